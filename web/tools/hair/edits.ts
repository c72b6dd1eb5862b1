// Edits of a hair step that tools and panels share. With the mirror on, what is done on one side of the head
// is done on the other too: a new primitive comes with its mirror image, an edit of one is an edit of both.

import type { HairEdit, HairScene } from './host';
import { MIDDLE, places, SHORTEST } from './measures';
import { lengthOf, type Line, quantised, resampled, smoothed } from './polyline';
import {
  added,
  isMiddle,
  mirrored,
  type Part,
  type Point,
  type Primitive,
  primitiveAt,
  removed,
  replaced,
  twinOf,
  withPart,
} from './style';

type Scene = Pick<HairScene, 'step' | 'height' | 'mirror'>;

/** A drawn line as it is kept: the tremor taken out, points evenly spaced, in few digits. */
export function kept(line: Line, height: number, spacing: number): Point[] {
  const fine = resampled(line, (spacing * height) / 3);
  return quantised(resampled(smoothed(fine, 4), spacing * height), places(height));
}

export const isTooShort = (line: Line, height: number): boolean => lengthOf(line) < SHORTEST * height;

export function addPrimitive({ step, height, mirror }: Scene, primitive: Primitive): HairEdit {
  const first = added(step, primitive);
  if (!mirror || isMiddle(primitive, MIDDLE * height)) return { step: first.style, selected: first.index };
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
  const { name: _, ...item } = primitive.item;
  const copy = { kind: primitive.kind, item } as Primitive;
  const by = height / 40;
  const aside = mappedBy(copy, by, places(height));
  const { style, index: at } = added(step, aside);
  return { step: style, selected: at };
}

function mappedBy(primitive: Primitive, by: number, digits: number): Primitive {
  const [x] = firstPoint(primitive);
  const side = x < 0 ? -by : by;
  return movedBy(primitive, side, digits);
}
