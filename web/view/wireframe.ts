import { BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, Vector3 } from 'three';
import type { ModelView } from './model-view';
import type { Palette } from './palette';
import { polygonEdges } from './polygon-edges';

/** The file's own edges, drawn over the surface; they share its vertices, so they move with it. */
export class Wireframe {
  readonly lines: LineSegments;
  readonly #material = new LineBasicMaterial({ transparent: true, depthWrite: false, toneMapped: false });
  readonly #edgeLength: number;
  #strength = 0.4;

  constructor(private readonly view: ModelView) {
    const { positions, faceOffsets, faceVertices } = view.model;
    // Towards the eye by a trifle, so that lines win over the surface they lie on.
    this.#material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace(
        '#include <project_vertex>',
        '#include <project_vertex>\ngl_Position.z -= 0.0004 * gl_Position.w;',
      );
    };
    const edges = polygonEdges(faceOffsets, faceVertices, positions.length / 3);
    const geometry = new BufferGeometry();
    const drawn = view.surface.getAttribute('position');
    geometry.setAttribute('position', drawn);
    geometry.setIndex(new BufferAttribute(edges, 1));
    this.lines = new LineSegments(geometry, this.#material);
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 1;
    const [a, b] = [new Vector3(), new Vector3()];
    let total = 0;
    for (let e = 0; e < edges.length; e += 2) {
      total += a
        .fromBufferAttribute(drawn, edges[e]!)
        .distanceTo(b.fromBufferAttribute(drawn, edges[e + 1]!));
    }
    this.#edgeLength = edges.length > 0 ? total / (edges.length / 2) : 1;
  }

  setPalette(palette: Palette): void {
    this.#material.color = new Color(palette.wire);
    this.#strength = palette.wireStrength;
  }

  /** Just before a picture. Lines closer than a few pixels would only darken the model: they fade instead. */
  prepare(pixelSize: number): void {
    this.lines.geometry.setAttribute('position', this.view.geometry.getAttribute('position'));
    const gap = this.#edgeLength / pixelSize;
    this.#material.opacity = this.#strength * Math.min(1, Math.max(0.16, (gap - 1.5) / 9));
  }

  dispose(): void {
    // The position attribute belongs to the model.
    this.lines.geometry.deleteAttribute('position');
    this.lines.geometry.dispose();
    this.#material.dispose();
  }
}
