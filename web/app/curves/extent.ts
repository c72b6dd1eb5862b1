import { boxOf, sizeOf } from '../../core/box';
import type { EvaluatorPort } from '../evaluated';

const known = new WeakMap<Float64Array, number>();

/** The largest extent of points along an axis; those that are not finite are left out. */
export function extentOf(positions: Float64Array): number {
  let size = known.get(positions);
  if (size !== undefined) return size;
  size = Math.max(0, ...sizeOf(boxOf(positions)));
  known.set(positions, size);
  return size;
}

/** That of the model on screen; 0 while there is none. */
export function extentShown({ result }: Pick<EvaluatorPort, 'result'>): number {
  const positions = result.peek()?.shown.model.positions;
  return positions ? extentOf(positions) : 0;
}
