// A style on another head: its strokes move as the box around the scalp does.

import { type Box, boxOf, coordinatesOf } from '../../core/box';
import { roundTo } from '../../core/decimal';
import type { Model } from '../../core/model';
import type { HairStep } from '../../recipe/recipe';
import { scalpOf } from '../../run/steps/hair/scalp';
import { places } from '../../tools/hair/measures';
import { mapped, type Point, primitivesOf, withPrimitives } from '../../tools/hair/style';
import { tallness } from './head-height';

interface Head {
  readonly model: Model;
  readonly scalp: Uint32Array;
}

/** @param to  a head that brings a scalp; without one, or on the same head, strokes stay where they are */
export function fitted(step: HairStep, from: Head, to: Model): HairStep {
  const before = boxAround(from.model, from.scalp);
  const after = boxAround(to, scalpOf({}, to));
  if (!before || !after) return step;
  const digits = places(tallness(to));
  const move = (point: readonly number[]): Point =>
    point.map((x, k) => {
      const [low, high] = [before.low[k]!, before.high[k]!];
      const [newLow, newHigh] = [after.low[k]!, after.high[k]!];
      const scale = high > low ? (newHigh - newLow) / (high - low) : 1;
      return roundTo(newLow + (x - low) * scale, digits);
    }) as Point;
  return withPrimitives(
    step,
    primitivesOf(step).map((primitive) => mapped(primitive, move)),
  );
}

const boxAround = ({ positions }: Model, vertices: Uint32Array): Box | null =>
  vertices.length === 0 ? null : boxOf(coordinatesOf(positions, vertices));
