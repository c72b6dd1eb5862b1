// What of a pen drawing lies under the pointer.

import type { Vec3 } from '../values';
import { nearestOnSegment } from './on-segment';
import type { PenDrawing, PenHit, PenPart } from './types';

/** CSS pixels. */
const LINE_REACH = 8;
const END_REACH = 12;
const RING_REACH = 7;

/** A place on the screen, CSS pixels; z < 0 behind the eye. */
export interface OnScreen {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/**
 * The nearest place of every line within reach, nearest line first.
 *
 * @param seen  3 per point of the drawing: CSS pixels and depth, negative behind the eye
 */
export function linesNear(
  { points, offsets, closed }: Pick<PenDrawing, 'points' | 'offsets' | 'closed'>,
  seen: Float32Array,
  x: number,
  y: number,
): PenHit[] {
  const hits: PenHit[] = [];
  for (let line = 0; line + 1 < offsets.length; line++) {
    const [first, end] = [offsets[line]!, offsets[line + 1]!];
    let nearest = LINE_REACH;
    let met: { readonly segment: number; readonly t: number } | null = null;
    for (let i = first; i < end; i++) {
      const j = i + 1 < end ? i + 1 : first;
      if (i + 1 === end && !closed[line]) break;
      if (seen[3 * i + 2]! < 0 || seen[3 * j + 2]! < 0) continue;
      const [a, b] = [i, j].map((at) => ({ x: seen[3 * at]!, y: seen[3 * at + 1]! })) as [OnScreen, OnScreen];
      const { t, distance } = nearestOnSegment(a, b, x, y);
      if (distance > nearest) continue;
      nearest = distance;
      met = { segment: i - first, t };
    }
    if (!met) continue;
    const i = first + met.segment;
    const j = i + 1 < end ? i + 1 : first;
    const along = (k: number): number =>
      points[3 * i + k]! + met.t * (points[3 * j + k]! - points[3 * i + k]!);
    const point: Vec3 = [along(0), along(1), along(2)];
    hits.push({ line, ...met, point, distance: nearest });
  }
  return hits.sort((a, b) => a.distance - b.distance);
}

/**
 * What of the line in hand lies under the pointer: its ends win over the line, the line over the ring.
 *
 * @param line    as seen, two places or more
 * @param radius  of the ring, CSS pixels
 */
export function holdAt(
  line: readonly OnScreen[],
  centre: OnScreen,
  radius: number,
  x: number,
  y: number,
): PenPart | null {
  const away = ({ x: px, y: py, z }: OnScreen): number => (z < 0 ? Infinity : Math.hypot(px - x, py - y));
  const [start, end] = [away(line[0]!), away(line.at(-1)!)];
  if (Math.min(start, end) <= END_REACH) return start <= end ? 'start' : 'end';
  for (let i = 0; i + 1 < line.length; i++) {
    const [a, b] = [line[i]!, line[i + 1]!];
    if (a.z < 0 || b.z < 0) continue;
    if (nearestOnSegment(a, b, x, y).distance <= LINE_REACH) return 'line';
  }
  return Math.abs(away(centre) - radius) <= RING_REACH ? 'ring' : null;
}
