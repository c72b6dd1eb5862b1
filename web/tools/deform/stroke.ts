import type { Hit, PointerSample } from '../../view/types';
import type { DeformHost, DeformScene } from './host';

/** Parts of the brush radius between two stamps along the path. */
const SPACING = 0.4;

/** One brush stroke: the vertices it has gone over. Fast moves are filled in along the pointer's path. */
export class Stroke {
  readonly touched = new Set<number>();
  #last: PointerSample | null = null;

  constructor(
    private readonly host: DeformHost,
    private readonly scene: DeformScene,
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
    const inside = this.host.view.verticesWithin(hit, radius * this.host.view.pixelSize(hit.point));
    const set = this.scene.graph.withCopies(inside.length > 0 ? inside : [hit.vertex]);
    for (const v of this.scene.mirrored(set)) this.touched.add(v);
  }
}

/** CSS pixels; a pen's pressure makes it half to one and a half times as wide. */
export const radiusOf = (host: DeformHost, { pointerType, pressure }: PointerSample): number =>
  host.brush().radius * (pointerType === 'pen' ? 0.5 + pressure : 1);
