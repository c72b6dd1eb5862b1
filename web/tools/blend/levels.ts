// Where an upright body is measured: by height, then by what is widest or narrowest about there. Pure.

import { boxOf, sizeOf } from '../../core/box';
import { type Direction, hullLength, sectionLoop } from './section';

export type Preset = 'chest' | 'waist' | 'hip';
export const PRESETS = ['chest', 'waist', 'hip'] as const satisfies readonly Preset[];

/** Shares of the height between which each lies, and what it is there. */
const RANGES: Readonly<
  Record<Preset, { readonly low: number; readonly high: number; readonly wide: boolean }>
> = {
  chest: { low: 0.66, high: 0.78, wide: true },
  waist: { low: 0.58, high: 0.67, wide: false },
  hip: { low: 0.47, high: 0.55, wide: true },
};
/** A body is so many times as tall as it is thick: more than a head is. */
const SLENDER = 2.5;
/** Levels tried in a range. */
const TRIED = 12;
/** From one level to the next a body does not become so many times wider. */
const JUMP = 1.12;

export class Levels {
  readonly #low: number;
  readonly #high: number;
  /** A place that the axis of the body goes through. */
  readonly #axis: Direction;

  /** @param up  of unit length */
  constructor(
    private readonly positions: Float64Array,
    private readonly triangles: Uint32Array,
    readonly up: Direction,
  ) {
    let [low, high] = [Infinity, -Infinity];
    const sum: [number, number, number] = [0, 0, 0];
    const count = positions.length / 3;
    for (let v = 0; v < count; v++) {
      const height = this.#heightOf(v);
      low = Math.min(low, height);
      high = Math.max(high, height);
      for (let k = 0; k < 3; k++) sum[k] = sum[k]! + positions[3 * v + k]! / count;
    }
    this.#low = low;
    this.#high = high;
    this.#axis = sum;
  }

  get height(): number {
    return this.#high - this.#low;
  }

  /** Whether it is longest along `up` and much longer than it is thick, as a standing body is. */
  get isUpright(): boolean {
    const sizes = sizeOf(boxOf(this.positions));
    return Math.max(...sizes) <= 1.001 * this.height && Math.min(...sizes) < this.height / SLENDER;
  }

  /** The vertex whose section a measure is taken of; `null` where no closed line is found. */
  preset(name: Preset): number | null {
    const { low, high, wide } = RANGES[name];
    let best: { readonly vertex: number; readonly girth: number } | null = null;
    let before = Infinity;
    for (let i = 0; i <= TRIED; i++) {
      const vertex = this.at(low + ((high - low) * i) / TRIED);
      const loop = sectionLoop(this.positions, this.triangles, vertex, this.up);
      if (!loop) continue;
      const girth = hullLength(loop, this.up);
      // From here on up the arms are part of the cut.
      if (girth > JUMP * before) break;
      before = girth;
      if (!best || (wide ? girth > best.girth : girth < best.girth)) best = { vertex, girth };
    }
    return best?.vertex ?? null;
  }

  /** The vertex at a share of the height that is nearest to the body's axis. */
  at(share: number): number {
    const wanted = this.#low + Math.min(1, Math.max(0, share)) * this.height;
    /** A vertex off the level counts as farther away by much more than that. */
    const STRICT = 8;
    let [best, least] = [0, Infinity];
    for (let v = 0; v < this.positions.length / 3; v++) {
      const off = this.#heightOf(v) - wanted;
      if (Math.abs(off) > 0.02 * this.height) continue;
      const far = this.#fromAxis(v) + STRICT * Math.abs(off);
      if (far < least) [best, least] = [v, far];
    }
    return best;
  }

  /** Where a vertex is, as a share of the height. */
  shareOf(vertex: number): number {
    return this.height > 0 ? (this.#heightOf(vertex) - this.#low) / this.height : 0;
  }

  /** The vertex of a level that lies so much higher, the next one up or down at least. */
  moved(vertex: number, by: number): number {
    for (let step = 1; step <= 8; step++) {
      const next = this.at(this.shareOf(vertex) + step * by);
      if (next !== vertex && Math.sign(this.shareOf(next) - this.shareOf(vertex)) === Math.sign(by))
        return next;
    }
    return vertex;
  }

  #heightOf(v: number): number {
    const p = this.positions;
    return this.up[0] * p[3 * v]! + this.up[1] * p[3 * v + 1]! + this.up[2] * p[3 * v + 2]!;
  }

  #fromAxis(v: number): number {
    const d = [0, 1, 2].map((k) => this.positions[3 * v + k]! - this.#axis[k]!);
    const along = d.reduce((sum, x, k) => sum + x * this.up[k]!, 0);
    return Math.hypot(...d.map((x, k) => x - along * this.up[k]!));
  }
}
