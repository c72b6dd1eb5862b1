// The kernel's curve through control points, as the screen draws it.

import type { Vec3 } from '../../view/types';
import { add, gap, scaled, subtract, unit } from '../geometry';

/** Tangents of a rigid segment, in lengths of it. */
const RIGID = 0.15;

/** Points drawn from one control point to the next. */
export const PIECES = 12;

/**
 * Centripetal Catmull–Rom by the tangents of Barry and Goldman's non-uniform form (knots |p_{i+1} − p_i|^½); at the two
 * ends the curve leaves along the chord. As `wasm/include/lissom/curve/spline.h` has it.
 *
 * @returns `pieces` points for each segment, and the last control point
 */
export function splinePoints(
  points: readonly Vec3[],
  rigid: readonly number[] = [],
  pieces = PIECES,
): Vec3[] {
  const out: Vec3[] = [];
  for (let i = 0; i + 1 < points.length; i++)
    for (let k = 0; k < pieces; k++) out.push(onSegment(points, i, k / pieces, rigid.includes(i)));
  return [...out, points.at(-1)!];
}

/** @param t  0 at the first control point, 1 at the last; beyond them straight on */
export function splineAt(points: readonly Vec3[], t: number): Vec3 {
  const last = points.length - 2;
  const at = t * (last + 1);
  if (at < 0) return add(points[0]!, scaled(subtract(points[1]!, points[0]!), at));
  if (at > last + 1)
    return add(points[last + 1]!, scaled(subtract(points[last + 1]!, points[last]!), at - last - 1));
  const i = Math.min(last, Math.floor(at));
  return onSegment(points, i, at - i, false);
}

/** Unit direction at a control point. */
export function tangentAt(points: readonly Vec3[], i: number): Vec3 {
  const [before, after] = [points[Math.max(0, i - 1)]!, points[Math.min(points.length - 1, i + 1)]!];
  return unit(subtract(after, before), [0, 0, 1]);
}

function onSegment(points: readonly Vec3[], i: number, u: number, rigid: boolean): Vec3 {
  const [p, q] = [points[i]!, points[i + 1]!];
  const chord = subtract(q, p);
  const m = rigid ? scaled(chord, RIGID) : tangent(points, i, i);
  const n = rigid ? scaled(chord, RIGID) : tangent(points, i, i + 1);
  const [u2, u3] = [u * u, u * u * u];
  const weights = [2 * u3 - 3 * u2 + 1, u3 - 2 * u2 + u, 3 * u2 - 2 * u3, u3 - u2] as const;
  return [0, 1, 2].map(
    (k) => weights[0] * p[k]! + weights[1] * m[k]! + weights[2] * q[k]! + weights[3] * n[k]!,
  ) as unknown as Vec3;
}

/** dp/du of segment `i` at one of its two control points. */
function tangent(points: readonly Vec3[], i: number, at: number): Vec3 {
  const chord = subtract(points[i + 1]!, points[i]!);
  const [before, here, after] = [points[at - 1], points[at]!, points[at + 1]];
  if (!before || !after) return chord;
  const [a, b] = [Math.sqrt(gap(before, here)), Math.sqrt(gap(here, after))];
  if (!(a > 0) || !(b > 0)) return chord;
  const own = Math.sqrt(gap(points[i]!, points[i + 1]!));
  return [0, 1, 2].map(
    (k) =>
      own * ((here[k]! - before[k]!) / a - (after[k]! - before[k]!) / (a + b) + (after[k]! - here[k]!) / b),
  ) as unknown as Vec3;
}
