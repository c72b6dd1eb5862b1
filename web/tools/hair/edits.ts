// Edits of a hair step that tools and panels share. With the mirror on, what is done on one side of the head
// is done on the other too: a new primitive comes with its mirror image, an edit of one is an edit of both.

import { roundTo } from '../../core/decimal';
import { type Line, lengthOf, quantised, resampled, smoothed } from '../stroke/polyline';
import type { HairEdit, HairScene } from './host';
import { MIDDLE, MIDDLE_TAIL, places, SHORTEST } from './measures';
import {
  added,
  isMiddle,
  mainPart,
  mapped,
  mirrored,
  type Part,
  type Point,
  type Primitive,
  pointsOf,
  primitiveAt,
  removed,
  replaced,
  twinOf,
  withPart,
} from './style';

type Scene = Pick<HairScene, 'step' | 'height' | 'mirror'>;

/** A drawn line as it is kept: the tremor taken out, points evenly spaced, in few digits. */
export const kept = (line: Line, height: number, spacing: number): Point[] =>
  quantised(evened(line, height, spacing), places(height));

export const evened = (line: Line, height: number, spacing: number): Line =>
  resampled(smoothed(resampled(line, (spacing * height) / 3), 4), spacing * height);

export const isTooShort = (line: Line, height: number): boolean => lengthOf(line) < SHORTEST * height;

export function addPrimitive({ step, height, mirror }: Scene, primitive: Primitive): HairEdit {
  const near = primitive.kind === 'ponytail' ? MIDDLE_TAIL : MIDDLE;
  if (mirror && isMiddle(primitive, near * height)) {
    const middle = added(
      step,
      mapped(primitive, ([, y, z]) => [0, y, z]),
    );
    return { step: middle.style, selected: middle.index };
  }
  const first = added(step, primitive);
  if (!mirror) return { step: first.style, selected: first.index };
  const both = added(first.style, mirrored(primitive));
  return { step: both.style, selected: first.index };
}

/** Puts a primitive in the place of another; its twin follows when the mirror is on. */
export function replacePrimitive({ step, mirror }: Scene, index: number, primitive: Primitive): HairEdit {
  const twin = mirror ? twinOf(step, index) : -1;
  const own = replaced(step, index, primitive);
  const old = primitiveAt(step, twin);
  if (!old) return { step: own, selected: index };
  const image = mirrored(primitive);
  const { name: _, hidden: __, ...rest } = image.item;
  const { name, hidden } = old.item;
  const item = { ...rest, ...(name !== undefined && { name }), ...(hidden !== undefined && { hidden }) };
  return { step: replaced(own, twin, { kind: image.kind, item } as Primitive), selected: index };
}

export const replacePart = (scene: Scene, index: number, part: Part, points: Point[]): HairEdit =>
  replacePrimitive(scene, index, withPart(primitiveAt(scene.step, index)!, part, points));

export function removePrimitive({ step, mirror }: Scene, index: number): HairEdit {
  const twin = mirror ? twinOf(step, index) : -1;
  const order = twin < 0 ? [index] : [index, twin].toSorted((a, b) => b - a);
  return { step: order.reduce((left, each) => removed(left, each), step), selected: null };
}

/** A copy of its own, selected, a little to the side so that it can be told from the first. */
export function duplicatePrimitive({ step, height }: Scene, index: number): HairEdit {
  const primitive = primitiveAt(step, index)!;
  const [[x] = [0]] = pointsOf(primitive, mainPart(primitive));
  const by = x < 0 ? -ASIDE * height : ASIDE * height;
  const digits = places(height);
  const copy = mapped(primitive, ([px, y, z]) => [roundTo(px + by, digits), y, z]);
  const { name: _, ...item } = copy.item;
  const { style, index: at } = added(step, { kind: copy.kind, item } as Primitive);
  return { step: style, selected: at };
}

const ASIDE = 1 / 40;
