import { Group } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import type { ModelView } from '../model-view';
import { ViewSpace } from '../view-space';
import { offsetsInView, packFields } from './pack';
import { SurfaceBlend } from './surface-blend';
import type { BlendPort, BlendSurface } from './types';

/** Moves the model on screen by a few transformations, all its vertices on the graphics card. */
class BlendLayer implements Layer, BlendPort {
  readonly group = new Group();
  #space = ViewSpace.identity;
  #model: ModelView | undefined;
  #surface: BlendSurface | null = null;
  #offsets: Float64Array | null = null;
  #blend: SurfaceBlend | null = null;

  constructor(private readonly context: LayerContext) {}

  readonly works = true;

  place(space: ViewSpace, model: ModelView | undefined): void {
    if (space === this.#space && model === this.#model) return;
    this.#drop();
    this.#space = space;
    this.#model = model;
    this.#surface = null;
    this.#offsets = null;
  }

  setSurface(surface: BlendSurface | null): boolean {
    this.#drop();
    this.#surface = surface;
    this.#offsets = null;
    this.#make();
    return this.#blend !== null;
  }

  move(offsets: Float64Array | null): void {
    this.#offsets = offsets;
    this.#show();
    this.context.redraw();
  }

  readBack(): ReturnType<BlendPort['readBack']> {
    if (!this.#blend || !this.#model) return null;
    const { places, normals } = this.#blend.read();
    return { positions: this.#model.space.toModelAll(places), normals };
  }

  restore(): void {
    // What was held is gone with the context.
    this.#model?.drawOwn();
    this.#blend = null;
    this.#make();
    this.#show();
  }

  dispose(): void {
    this.#drop();
  }

  #make(): void {
    const { renderer } = this.context;
    const surface = this.#surface;
    const model = this.#model;
    if (!surface || !model || surface.fields.length !== (surface.sets * model.model.positions.length) / 3)
      return;
    const packed = packFields(surface, model.space, renderer.capabilities.maxTextureSize);
    if (!packed) return;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    this.#blend = new SurfaceBlend(gl, surface, packed, model.drawnAt(model.model.positions));
    renderer.resetState();
  }

  #show(): void {
    const { renderer } = this.context;
    const model = this.#model;
    if (!this.#blend || !model) return;
    if (!this.#offsets) {
      model.drawOwn();
      return;
    }
    this.#blend.move(offsetsInView(this.#offsets, model.space));
    renderer.resetState();
    model.drawOther(this.#blend.position, this.#blend.normal);
  }

  #drop(): void {
    this.#model?.drawOwn();
    this.#blend?.dispose();
    if (this.#blend) this.context.renderer.resetState();
    this.#blend = null;
  }
}

export const BLEND: LayerKind<BlendPort> = {
  id: 'blend',
  make: (context) => new BlendLayer(context),
};
