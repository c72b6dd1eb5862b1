// Where the strokes of a hair step may lie. They are sampled at the size of the head's grid, so one that led to the moon
// would take all memory and all time.

import { LissomError } from '../../../core/errors';
import type { Model } from '../../../core/model';
import { MAX_COORDINATE } from '../../../recipe/limits';
import type { HairStep } from '../../../recipe/recipe';

/**
 * How many diagonals of the head a stroke may lie from its middle. Hair to the ground reaches seven; beyond its volume a
 * stroke changes nothing, which a warning tells, and beyond this it costs more than a warning is worth.
 */
const REACH = 100;

type Points = HairStep['streams'][number]['points'];

/** @throws LissomError `stroke-too-far`; `head-too-large` for hair that single precision could not hold */
export function checkReach({ streams, partings, ponytails }: HairStep, head: Model): void {
  const { middle, diagonal } = boxOf(head.positions);
  if (diagonal > MAX_COORDINATE)
    throw new LissomError(
      'head-too-large',
      `${JSON.stringify(head.name)} measures ${diagonal.toPrecision(3)}, and hair is grown on heads of at most ` +
        `${MAX_COORDINATE}; scale the model down, or remove the vertices that lie far out.`,
    );
  const check = (points: Points, place: string): void => {
    const at = points.findIndex((point) => !(distance(point, middle) <= REACH * diagonal));
    if (at < 0) return;
    const away = distance(points[at]!, middle).toPrecision(3);
    throw new LissomError(
      'stroke-too-far',
      `${place}[${at}]: the point lies ${away} from the middle of ${JSON.stringify(head.name)}, which measures ` +
        `${diagonal.toPrecision(3)}; move it within ${(REACH * diagonal).toPrecision(3)}, or remove the stroke.`,
    );
  };
  for (const [k, { points }] of streams.entries()) check(points, `streams[${k}].points`);
  for (const [k, { points }] of partings.entries()) check(points, `partings[${k}].points`);
  for (const [k, { spine, section, profiles }] of ponytails.entries()) {
    check(spine, `ponytails[${k}].spine`);
    check(section, `ponytails[${k}].section`);
    for (const [p, profile] of profiles.entries()) check(profile, `ponytails[${k}].profiles[${p}]`);
  }
}

/** Without a finite vertex, which the kernel refuses by itself, there is no box to measure by. */
function boxOf(positions: Float64Array): { readonly middle: readonly number[]; readonly diagonal: number } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const x = positions[i]!;
    if (!Number.isFinite(x)) continue;
    low[i % 3] = Math.min(low[i % 3]!, x);
    high[i % 3] = Math.max(high[i % 3]!, x);
  }
  const middle = low.map((x, k) => (x + high[k]!) / 2);
  return { middle, diagonal: Math.hypot(...low.map((x, k) => high[k]! - x)) };
}

const distance = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot(...a.map((x, k) => x - b[k]!));
