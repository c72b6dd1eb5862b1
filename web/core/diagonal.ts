import { boxOf, sizeOf } from './box';

const known = new WeakMap<Float64Array, number>();

/** Of a model's bounding box. Positions never change in place, so it is measured once. */
export function diagonalOf(positions: Float64Array): number {
  let diagonal = known.get(positions);
  if (diagonal === undefined) {
    diagonal = Math.hypot(...sizeOf(boxOf(positions)));
    known.set(positions, diagonal);
  }
  return diagonal;
}
