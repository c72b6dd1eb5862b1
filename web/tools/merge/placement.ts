// The part's plane map laid on the target's by hand: moved, turned, scaled (Fu 3.4.1, step 2). Plane points only.

import type { MapPlacement } from '../../kernel/contract/merge';

export type PlanePoint = readonly [number, number];
export type PlacementHandle = 'move' | 'turn' | 'scale';

const SMALLEST = 0.02;
const LARGEST = 50;

/** Where a point of the part's map lies on the target's: scaled, turned, then moved. */
export function placed({ shift, turn, scale }: MapPlacement, [x, y]: PlanePoint): PlanePoint {
  const angle = (turn * Math.PI) / 180;
  const [c, s] = [scale * Math.cos(angle), scale * Math.sin(angle)];
  return [c * x - s * y + shift[0], s * x + c * y + shift[1]];
}

/** The placement after one of its handles has been dragged from one plane point to another. */
export function dragged(
  from: MapPlacement,
  handle: PlacementHandle,
  start: PlanePoint,
  end: PlanePoint,
): MapPlacement {
  const { shift, turn, scale } = from;
  if (handle === 'move')
    return { ...from, shift: [shift[0] + end[0] - start[0], shift[1] + end[1] - start[1]] };
  const [a, b] = [arm(shift, start), arm(shift, end)];
  if (handle === 'turn') return { ...from, turn: wrapped(turn + ((b.angle - a.angle) * 180) / Math.PI) };
  const by = a.length > 0 ? b.length / a.length : 1;
  return { ...from, scale: Math.min(LARGEST, Math.max(SMALLEST, scale * by)) };
}

/** To (−180, 180]. */
const wrapped = (degrees: number): number => 180 - ((((180 - degrees) % 360) + 360) % 360);

function arm([cx, cy]: readonly [number, number], [x, y]: PlanePoint) {
  return { length: Math.hypot(x - cx, y - cy), angle: Math.atan2(y - cy, x - cx) };
}
