import { Group } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import type { ModelView } from '../model-view';
import { ViewSpace } from '../view-space';
import { offsetsInView, packFields } from './pack';
import { SurfaceBlend } from './surface-blend';
import type { BlendPort, BlendSurface } from './types';

/** Milliseconds from how a drag was shown to its result: long enough to be seen as one movement, too short to wait for. */
const ARRIVAL = 160;

/** Moves the model on screen by a few transformations, all its vertices on the graphics card. */
class BlendLayer implements Layer, BlendPort {
  readonly group = new Group();
  #space = ViewSpace.identity;
  #model: ModelView | undefined;
  #surface: BlendSurface | null = null;
  #offsets: Float64Array | null = null;
  #blend: SurfaceBlend | null = null;
  /** Another number, another movement: what is under way ends. */
  #arrivals = 0;

  constructor(private readonly context: LayerContext) {}

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
    this.#arrivals++;
    this.#offsets = offsets;
    this.#show();
    this.context.redraw();
  }

  arrive(): void {
    const [blend, model, offsets] = [this.#blend, this.#model, this.#offsets];
    const still = this.context.test || window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (!blend || !model || !offsets || still) {
      this.move(null);
      return;
    }
    const own = ++this.#arrivals;
    const started = performance.now();
    blend.goTo(model.drawn());
    const go = () => {
      if (own !== this.#arrivals) return;
      const share = (performance.now() - started) / ARRIVAL;
      if (share >= 1) {
        this.move(null);
        return;
      }
      this.#show(share * share * (3 - 2 * share));
      this.context.redraw();
      requestAnimationFrame(go);
    };
    go();
  }

  readBack(): ReturnType<BlendPort['readBack']> {
    if (!this.#blend || !this.#model) return null;
    const { places, normals } = this.#blend.read();
    return { positions: this.#model.space.toModelAll(places), normals };
  }

  restore(): void {
    // What was held is gone with the context.
    this.#arrivals++;
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

  /** @param arrival  how much of the way to the shape that was set otherwise */
  #show(arrival = 0): void {
    const { renderer } = this.context;
    const model = this.#model;
    if (!this.#blend || !model) return;
    if (!this.#offsets) {
      model.drawOwn();
      return;
    }
    this.#blend.move(offsetsInView(this.#offsets, model.space), arrival);
    renderer.resetState();
    model.drawOther(this.#blend.position, this.#blend.normal);
  }

  #drop(): void {
    this.#arrivals++;
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
