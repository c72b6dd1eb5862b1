import { roundTo } from '../../core/decimal';
import { placesFor } from '../../tools/stroke/polyline';
import { useHair } from './use-hair';

/** Lengths as people set them, in parts of the head's height, and as recipes hold them, in model units. */
export function usePercent() {
  const { actions: hair } = useHair();
  const height = hair.headHeight();
  // Two digits more than a stroke's: lengths of hair go down to its thickness.
  const digits = Math.min(15, placesFor(height) + 2);
  return {
    /** @param usual  percent where the recipe says nothing */
    percent: (length: number | undefined, usual: number): number =>
      length === undefined ? usual : (100 * length) / height,
    length: (percent: number): number => roundTo((percent * height) / 100, digits),
  };
}
