// Where the strokes of a hair step may lie. They are sampled at the size of the head's grid, so one that led to the moon
// would take all memory and all time.

import { boxOf, middleOf, sizeOf } from '../../../core/box';
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
  // Without a finite vertex, which the kernel refuses by itself, there is no box to measure by.
  const box = boxOf(head.positions);
  const middle = middleOf(box);
  const diagonal = Math.hypot(...sizeOf(box));
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

const distance = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot(...a.map((x, k) => x - b[k]!));
