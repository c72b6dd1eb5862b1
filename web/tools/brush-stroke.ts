import type { Hit, PointerSample, ViewportPort } from '../view/types';
import type { MeshGraph } from './mesh-graph';

export interface Brush {
  /** CSS pixels. */
  readonly radius: number;
  readonly erase: boolean;
}

/** What a stroke under way has painted so far. */
export interface Paint {
  /** What it is: the region of interest, a handle, … */
  readonly kind: string;
  readonly vertices: Uint32Array;
}

/** What painting needs of the app. */
export interface PaintHost {
  readonly view: Pick<ViewportPort, 'pick' | 'verticesWithin' | 'pixelSize' | 'setBrush'>;
  brush(): Brush;
  /** Shows a stroke under way without computing anything; `null` ends it. */
  showPaint(paint: Paint | null): void;
}

/** The surface that is painted on. */
export interface PaintScene {
  readonly graph: MeshGraph;
  /** The set together with what lies across the symmetry plane, when mirroring is on; else the set. */
  readonly mirrored: (vertices: Uint32Array) => Uint32Array;
  /** Vertices under the brush where it is no ball on the surface; radius in model units. */
  readonly under?: (hit: Hit, radius: number) => Uint32Array;
}

/** Parts of the brush radius between two stamps along the path. */
const SPACING = 0.4;

/** One brush stroke: the vertices it has gone over. Fast moves are filled in along the pointer's path. */
export class BrushStroke {
  readonly touched = new Set<number>();
  #last: PointerSample | null = null;

  constructor(
    private readonly host: PaintHost,
    private readonly scene: PaintScene,
  ) {}

  extend(samples: readonly PointerSample[]): void {
    for (const sample of samples) {
      const last = this.#last;
      const radius = radiusOf(this.host, sample);
      if (last) this.#between(last, sample, radius);
      if (sample.hit) this.#stamp(sample.hit, radius);
      this.#last = sample;
    }
  }

  /** Stamps between two samples, picked again on the screen so that the path bends with the surface. */
  #between(a: PointerSample, b: PointerSample, radius: number): void {
    const steps = Math.ceil(Math.hypot(b.x - a.x, b.y - a.y) / Math.max(1, radius * SPACING));
    for (let i = 1; i < steps; i++) {
      const hit = this.host.view.pick(a.x + ((b.x - a.x) * i) / steps, a.y + ((b.y - a.y) * i) / steps);
      if (hit) this.#stamp(hit, radius);
    }
  }

  #stamp(hit: Hit, radius: number): void {
    const reach = radius * this.host.view.pixelSize(hit.point);
    const inside = this.scene.under?.(hit, reach) ?? this.host.view.verticesWithin(hit, reach);
    const set = this.scene.graph.withCopies(inside.length > 0 ? inside : [hit.vertex]);
    for (const v of this.scene.mirrored(set)) this.touched.add(v);
  }
}

/** CSS pixels; a pen's pressure makes it half to one and a half times as wide. */
export const radiusOf = (host: Pick<PaintHost, 'brush'>, { pointerType, pressure }: PointerSample): number =>
  host.brush().radius * (pointerType === 'pen' ? 0.5 + pressure : 1);
