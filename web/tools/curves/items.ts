// Items of a curves step by number: a curve as a whole, or one of its control points.

import { MAX_CONTROLS } from '../../recipe/steps/curves';

export interface Grip {
  /** Numbers of the curve and of its control point; `null`: all of it. */
  readonly curve: number;
  readonly point: number | null;
}

const STRIDE = MAX_CONTROLS + 1;

export const itemOf = ({ curve, point }: Grip): number => STRIDE * curve + (point === null ? 0 : point + 1);

export function gripOf(item: number | null): Grip | null {
  if (item === null) return null;
  const place = item % STRIDE;
  return { curve: Math.floor(item / STRIDE), point: place === 0 ? null : place - 1 };
}
