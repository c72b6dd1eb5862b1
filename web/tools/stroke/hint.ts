// Hint strokes: a second stroke beside a curve, read by where it starts and ends (Fu 4.5, Fig 4.3 c to h).

import { gap, mix } from '../geometry';
import { arcAt, crossing, from, joined, type Line, nearestOn, type OnLine, smoothed, upTo } from './polyline';

/** Where on the curve a hint stroke acts: the place between two of its points. */
export type Place = Pick<OnLine, 'segment' | 't'>;

export type Hint =
  | { readonly kind: 'cut'; readonly at: Place }
  | { readonly kind: 'concatenate'; readonly at: Place }
  | { readonly kind: 'insert'; readonly first: Place; readonly last: Place };

/**
 * What a stroke beside a curve means, both as seen on the screen.
 *
 * A stroke that runs across the curve, away from it at both ends, cuts; one that starts near it and ends
 * far away continues it from there; one that starts and ends near it replaces what lies between.
 *
 * @param near  CSS pixels within which an end counts as near
 * @returns `null` when it means nothing: too short, or it neither starts near the curve nor crosses it
 */
export function readHint(curve: Line, stroke: Line, near: number): Hint | null {
  const [first, last] = [stroke[0], stroke.at(-1)];
  const start = first && nearestOn(curve, first);
  const end = last && nearestOn(curve, last);
  if (!start || !end) return null;
  const reach = Math.max(...stroke.map((point) => gap(point, first)));
  if (reach <= near) return null;
  if (start.distance <= near) {
    if (end.distance > near) return { kind: 'concatenate', at: start };
    return Math.abs(arcAt(curve, start) - arcAt(curve, end)) > near
      ? { kind: 'insert', first: start, last: end }
      : null;
  }
  const crossed = end.distance > near ? crossing(stroke, curve) : undefined;
  return crossed ? { kind: 'cut', at: crossed.onB } : null;
}

/**
 * The curve after a hint. It keeps its beginning: what follows it starts there.
 *
 * @param stroke  the hint stroke in model space; a cut does not look at it
 */
export function applyHint(curve: Line, hint: Hint, stroke: Line): Line {
  switch (hint.kind) {
    case 'cut':
      return upTo(curve, onCurve(curve, hint.at));
    case 'concatenate':
      return blended(upTo(curve, onCurve(curve, hint.at)), stroke.slice(1));
    case 'insert': {
      const forwards = hint.first.segment + hint.first.t <= hint.last.segment + hint.last.t;
      const [a, b] = forwards ? [hint.first, hint.last] : [hint.last, hint.first];
      const inner = (forwards ? [...stroke] : stroke.toReversed()).slice(1, -1);
      return blended(blended(upTo(curve, onCurve(curve, a)), inner), from(curve, onCurve(curve, b)));
    }
  }
}

const onCurve = (curve: Line, { segment, t }: Place) => ({
  segment,
  point: mix(curve[segment]!, curve[Math.min(segment + 1, curve.length - 1)]!, t),
});

/** Points on either side of a joint that are evened out. */
const BLEND = 3;

/** One line after the other, without a kink where they meet. */
function blended(a: Line, b: Line): Line {
  const line = joined(a, b);
  const joint = a.length;
  const low = Math.max(0, joint - BLEND);
  const high = Math.min(line.length, joint + BLEND);
  return [...line.slice(0, low), ...smoothed(line.slice(low, high), 2), ...line.slice(high)];
}
