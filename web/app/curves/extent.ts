import { boxOf, sizeOf } from '../../core/box';

const known = new WeakMap<Float64Array, number>();

/** The largest extent of points along an axis; those that are not finite are left out. */
export function extentOf(positions: Float64Array): number {
  let size = known.get(positions);
  if (size !== undefined) return size;
  size = Math.max(0, ...sizeOf(boxOf(positions)));
  known.set(positions, size);
  return size;
}
