import { type Strands, strandCount } from '../../core/strands';
import type { ViewSpace } from '../view-space';

/** The graphics card reads the same number of points of every strand. */
export interface EvenStrands {
  readonly count: number;
  readonly perStrand: number;
  /** 3 per point, drawn units, strand after strand. */
  readonly points: Float32Array;
  readonly low: readonly [number, number, number];
  readonly high: readonly [number, number, number];
}

const MOST_POINTS = 64;

/**
 * Strands with equally many points each, evenly spaced in a strand's own parameter: a strand that has that
 * many already keeps every point. A strand of one point, or with one that is not finite, shrinks to its root.
 *
 * @param most  strands beyond are left out
 */
export function resample(strands: Strands, space: ViewSpace, most = Infinity): EvenStrands {
  const { offsets, origin } = strands;
  const count = Math.min(strandCount(strands), most);
  const perStrand = longest(offsets, count);
  const points = new Float32Array(3 * count * perStrand);
  let [lowX, lowY, lowZ] = [Infinity, Infinity, Infinity];
  let [highX, highY, highZ] = [-Infinity, -Infinity, -Infinity];
  const { scale, centre, zUp } = space;
  // Subtracted first and in double precision: far from the origin both are large and nearly the same.
  const [ox, oy, oz] = [origin[0] - centre[0], origin[1] - centre[1], origin[2] - centre[2]];
  for (let s = 0; s < count; s++) {
    const first = offsets[s]!;
    const own = offsets[s + 1]! - first;
    const step = own > 1 ? (own - 1) / (perStrand - 1) : 0;
    const source = usable(strands.points, first, own) ? strands.points : undefined;
    for (let i = 0; i < perStrand; i++) {
      const at = i * step;
      const a = Math.min(Math.max(0, own - 2), Math.floor(at));
      const t = at - a;
      const p = 3 * (first + a);
      const q = own > 1 ? p + 3 : p;
      const x = ((source ? source[p]! + t * (source[q]! - source[p]!) : 0) + ox) * scale;
      const y = ((source ? source[p + 1]! + t * (source[q + 1]! - source[p + 1]!) : 0) + oy) * scale;
      const z = ((source ? source[p + 2]! + t * (source[q + 2]! - source[p + 2]!) : 0) + oz) * scale;
      const out = 3 * (s * perStrand + i);
      const up = zUp ? z : y;
      const front = zUp ? -y : z;
      points[out] = x;
      points[out + 1] = up;
      points[out + 2] = front;
      if (!source) continue;
      if (x < lowX) lowX = x;
      if (x > highX) highX = x;
      if (up < lowY) lowY = up;
      if (up > highY) highY = up;
      if (front < lowZ) lowZ = front;
      if (front > highZ) highZ = front;
    }
  }
  if (lowX > highX) return { count, perStrand, points, low: [0, 0, 0], high: [0, 0, 0] };
  return { count, perStrand, points, low: [lowX, lowY, lowZ], high: [highX, highY, highZ] };
}

function longest(offsets: Uint32Array, count: number): number {
  let most = 2;
  for (let s = 0; s < count; s++) most = Math.max(most, offsets[s + 1]! - offsets[s]!);
  return Math.min(MOST_POINTS, most);
}

function usable(points: Float32Array, first: number, own: number): boolean {
  let sum = 0;
  for (let i = 3 * first; i < 3 * (first + own); i++) sum += points[i]!;
  return own > 0 && sum - sum === 0;
}
