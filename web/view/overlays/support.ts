import { BufferAttribute, BufferGeometry, Group, Mesh } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import { ViewSpace } from '../view-space';
import { glass } from './glass';
import type { SupportPort, SupportSurface } from './types';

/** The surface that strokes fall on. */
class SupportOverlay implements Layer, SupportPort {
  readonly group = new Group();
  readonly aid = true;
  readonly #mesh = new Mesh(new BufferGeometry(), glass());
  #surface: SupportSurface | null = null;
  #space = ViewSpace.identity;

  constructor(private readonly context: LayerContext) {
    this.#mesh.visible = false;
    this.#mesh.frustumCulled = false;
    this.#mesh.renderOrder = 8;
    this.group.add(this.#mesh);
  }

  place(space: ViewSpace): void {
    this.#space = space;
    this.#draw();
  }

  setSupport(surface: SupportSurface | null): void {
    this.#surface = surface;
    this.#draw();
    this.context.redraw();
  }

  dispose(): void {
    this.#mesh.geometry.dispose();
    this.#mesh.material.dispose();
  }

  #draw(): void {
    const surface = this.#surface;
    const { geometry } = this.#mesh;
    this.#mesh.visible = surface !== null;
    geometry.dispose();
    if (!surface) return;
    const places = new Float32Array(surface.positions.length);
    this.#space.place(surface.positions, places);
    geometry.setAttribute('position', new BufferAttribute(places, 3));
    geometry.setIndex(new BufferAttribute(surface.triangles, 1));
    geometry.computeVertexNormals();
  }
}

export const SUPPORT: LayerKind<SupportPort> = {
  id: 'support',
  make: (context) => new SupportOverlay(context),
};
