import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshStandardMaterial,
  type OrthographicCamera,
  PerspectiveCamera,
} from 'three';
import { heatColour } from '../heat';
import type { Layer, LayerContext, LayerKind } from '../layer';
import type { ModelView } from '../model-view';
import { CLAY, type Palette } from '../palette';
import { ViewSpace } from '../view-space';
import type { Skin, SkinLook, SkinPort } from './types';

/** Of the veil: the model is seen through it. */
const VEIL = 0.5;

/** A skin over its model, or in its place. */
class SkinLayer implements Layer, SkinPort {
  readonly group = new Group();
  readonly #geometry = new BufferGeometry();
  readonly #veil = surface({ transparent: true, opacity: VEIL, depthWrite: false });
  readonly #solid = surface({ color: CLAY });
  readonly #painted = surface({ vertexColors: true });
  readonly #wire = new LineBasicMaterial({ transparent: true, depthWrite: false, toneMapped: false });
  readonly #mesh = new Mesh(this.#geometry, this.#veil);
  readonly #lines = new LineSegments(new BufferGeometry(), this.#wire);
  #look: SkinLook | null = null;
  #drawn: Skin | null = null;
  #space = ViewSpace.identity;
  #model: ModelView | undefined;
  /** Drawn units, mean. */
  #edgeLength = 1;
  #strength = 0.4;
  #height = 1;

  constructor(private readonly context: LayerContext) {
    // Towards the eye by a trifle: the edges lie on the surface, which lies on the model.
    this.#wire.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace(
        '#include <project_vertex>',
        '#include <project_vertex>\ngl_Position.z -= 0.0012 * gl_Position.w;',
      );
    };
    this.#mesh.renderOrder = 2;
    this.#lines.renderOrder = 3;
    for (const each of [this.#mesh, this.#lines]) each.frustumCulled = false;
    this.group.add(this.#mesh, this.#lines);
    this.group.visible = false;
  }

  setPalette(palette: Palette): void {
    this.#veil.color = new Color(palette.tints.azure).lerp(new Color(1, 1, 1), 0.15);
    this.#wire.color = new Color(palette.wire);
    this.#strength = Math.min(1, 1.15 * palette.wireStrength);
  }

  resize(_width: number, height: number): void {
    this.#height = height;
  }

  /** Lines closer than a few pixels would only darken the skin: they fade instead. */
  prepare(camera: PerspectiveCamera | OrthographicCamera): void {
    // The surface is nearer than the middle of the model.
    const far = Math.max(0.1, camera.position.length() - 0.6);
    const tall =
      camera instanceof PerspectiveCamera
        ? 2 * far * Math.tan((Math.PI / 360) * camera.fov)
        : (camera.top - camera.bottom) / camera.zoom;
    const gap = (this.#edgeLength * this.#height) / tall;
    this.#wire.opacity = this.#strength * Math.min(1, Math.max(0.12, (gap - 1.5) / 9));
  }

  place(space: ViewSpace, model: ModelView | undefined): void {
    this.#showModel(true);
    this.#space = space;
    this.#model = model;
    this.#drawn = null;
    this.#draw();
  }

  setSkin(look: SkinLook | null): void {
    this.#look = look;
    this.#draw();
    this.context.redraw();
  }

  dispose(): void {
    this.#showModel(true);
    this.#geometry.dispose();
    this.#lines.geometry.dispose();
    for (const each of [this.#veil, this.#solid, this.#painted, this.#wire]) each.dispose();
  }

  #draw(): void {
    const look = this.#look;
    this.group.visible = look !== null && this.#model !== undefined;
    this.#showModel(!look?.alone);
    if (!look) return;
    if (look.skin !== this.#drawn) this.#shape(look.skin);
    this.#drawn = look.skin;
    const { heat } = look;
    if (heat) this.#geometry.setAttribute('color', new BufferAttribute(coloursOf(heat), 3));
    this.#mesh.material = heat ? this.#painted : look.alone ? this.#solid : this.#veil;
    this.#lines.visible = look.edges;
  }

  #shape({ triangles, positions }: Skin): void {
    const places = new Float32Array(positions.length);
    this.#space.place(positions, places);
    // Attributes of another length are other buffers: the old ones go with the geometry's.
    this.#geometry.dispose();
    this.#lines.geometry.dispose();
    this.#geometry.deleteAttribute('normal');
    this.#geometry.setAttribute('position', new BufferAttribute(places, 3));
    this.#geometry.setIndex(new BufferAttribute(triangles, 1));
    this.#geometry.computeVertexNormals();
    this.#lines.geometry.setAttribute('position', this.#geometry.getAttribute('position'));
    const edges = edgesOf(triangles);
    this.#lines.geometry.setIndex(new BufferAttribute(edges, 1));
    this.#edgeLength = meanLength(places, edges);
  }

  #showModel(shown: boolean): void {
    if (this.#model) this.#model.mesh.visible = shown;
  }
}

export const SKIN: LayerKind<SkinPort> = {
  id: 'match-skin',
  make: (context) => new SkinLayer(context),
};

/** Lies over the model where both are in one place, but for what its triangles are flatter than that: some thousandths of the size. */
const surface = (options: ConstructorParameters<typeof MeshStandardMaterial>[0]) =>
  new MeshStandardMaterial({
    roughness: 0.65,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: -2,
    polygonOffsetUnits: -400,
    ...options,
  });

function coloursOf(heat: Float32Array): Float32Array {
  const colours = new Float32Array(3 * heat.length);
  for (let v = 0; v < heat.length; v++) colours.set(heatColour(0.5 + heat[v]! / 2), 3 * v);
  return colours;
}

function meanLength(places: Float32Array, edges: Uint32Array): number {
  let sum = 0;
  for (let e = 0; e < edges.length; e += 2) {
    const [a, b] = [3 * edges[e]!, 3 * edges[e + 1]!];
    sum += Math.hypot(
      places[a]! - places[b]!,
      places[a + 1]! - places[b + 1]!,
      places[a + 2]! - places[b + 2]!,
    );
  }
  return edges.length > 0 ? (2 * sum) / edges.length : 1;
}

/** Each edge once, as a pair of vertices. */
export function edgesOf(triangles: Uint32Array): Uint32Array {
  const seen = new Set<number>();
  const edges: number[] = [];
  const count = triangles.reduce((most, v) => Math.max(most, v), 0) + 1;
  for (let t = 0; t < triangles.length; t += 3)
    for (let k = 0; k < 3; k++) {
      const [a, b] = [triangles[t + k]!, triangles[t + ((k + 1) % 3)]!];
      const key = Math.min(a, b) * count + Math.max(a, b);
      if (seen.has(key)) continue;
      seen.add(key);
      edges.push(a, b);
    }
  return Uint32Array.from(edges);
}
