import { Group, MathUtils } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import type { ModelView } from '../model-view';
import { ViewSpace } from '../view-space';
import { MovedSurface } from './moved-surface';
import type { MotionPort, MotionTable, SurfaceMotion } from './types';

/** Milliseconds from how a drag was shown to its result: long enough to be seen as one movement, too short to wait for. */
const ARRIVAL = 160;

/** Moves the model on screen by a small table, all its vertices on the graphics card. */
class MotionLayer implements Layer, MotionPort {
  readonly group = new Group();
  #space = ViewSpace.identity;
  #model: ModelView | undefined;
  #motion: SurfaceMotion | null = null;
  #table: MotionTable | null = null;
  #moved: MovedSurface | null = null;
  /** Another number, another movement: what is under way ends. */
  #arrivals = 0;

  constructor(private readonly context: LayerContext) {}

  place(space: ViewSpace, model: ModelView | undefined): void {
    if (space === this.#space && model === this.#model) return;
    this.#drop();
    this.#space = space;
    this.#model = model;
    this.#motion = null;
    this.#table = null;
  }

  setMotion(motion: SurfaceMotion | null): boolean {
    this.#drop();
    this.#motion = motion;
    this.#table = null;
    this.#make();
    return this.#moved !== null;
  }

  move(table: MotionTable | null): void {
    this.#arrivals++;
    this.#table = table;
    this.#show();
    this.context.reshaped();
  }

  arrive(): void {
    const [moved, model, table] = [this.#moved, this.#model, this.#table];
    const still = this.context.test || window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (!moved || !model || !table || this.#motion?.exact || still) {
      this.move(null);
      return;
    }
    const own = ++this.#arrivals;
    const started = performance.now();
    moved.goTo(model.drawn());
    const go = () => {
      if (own !== this.#arrivals) return;
      const share = (performance.now() - started) / ARRIVAL;
      if (share >= 1) {
        this.move(null);
        return;
      }
      this.#show(MathUtils.smoothstep(share, 0, 1));
      this.context.reshaped();
      requestAnimationFrame(go);
    };
    go();
  }

  readBack(): ReturnType<MotionPort['readBack']> {
    if (!this.#moved || !this.#model) return null;
    const { places, normals } = this.#moved.read();
    return { positions: this.#model.space.toModelAll(places), normals };
  }

  restore(): void {
    // What was held is gone with the context.
    this.#arrivals++;
    this.#model?.drawOwn();
    this.#moved = null;
    this.#make();
    this.#show();
  }

  dispose(): void {
    this.#drop();
  }

  #make(): void {
    const { renderer } = this.context;
    const motion = this.#motion;
    const model = this.#model;
    if (!motion || !model || motion.vertexCount !== model.model.positions.length / 3) return;
    const packed = motion.packed(model.space, renderer.capabilities.maxTextureSize);
    if (!packed) return;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    this.#moved = new MovedSurface(gl, packed, model.drawnAt(model.model.positions));
    renderer.resetState();
  }

  /** @param arrival  how much of the way to the shape that was set otherwise */
  #show(arrival = 0): void {
    const { renderer } = this.context;
    const model = this.#model;
    if (!this.#moved || !model) return;
    if (!this.#table) {
      model.drawOwn();
      return;
    }
    this.#moved.move(this.#table, arrival);
    renderer.resetState();
    model.drawOther(this.#moved.position, this.#moved.normal);
  }

  #drop(): void {
    this.#arrivals++;
    this.#model?.drawOwn();
    this.#moved?.dispose();
    if (this.#moved) this.context.renderer.resetState();
    this.#moved = null;
  }
}

export const MOTION: LayerKind<MotionPort> = {
  id: 'motion',
  make: (context) => new MotionLayer(context),
};
