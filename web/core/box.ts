type Triple = readonly [number, number, number];

/** The least and the greatest of each coordinate; infinite where there is nothing. */
export interface Box {
  readonly low: Triple;
  readonly high: Triple;
}

/**
 * The box around places; coordinates that are not finite are left out.
 *
 * @param coordinates  x, y, z of one place after the other
 */
export function boxOf(coordinates: Iterable<number>): Box {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  let k = 0;
  for (const x of coordinates) {
    if (Number.isFinite(x)) {
      low[k] = Math.min(low[k]!, x);
      high[k] = Math.max(high[k]!, x);
    }
    k = k === 2 ? 0 : k + 1;
  }
  return { low, high };
}

/** Coordinates of some of the places. */
export function* coordinatesOf(places: ArrayLike<number>, which: Iterable<number>): Iterable<number> {
  for (const i of which) for (let k = 0; k < 3; k++) yield places[3 * i + k]!;
}

export const middleOf = ({ low, high }: Box): Triple => each((k) => (low[k]! + high[k]!) / 2);

/** Along each axis; negative where there is nothing. */
export const sizeOf = ({ low, high }: Box): Triple => each((k) => high[k]! - low[k]!);

const each = (of: (k: number) => number): Triple => [of(0), of(1), of(2)];
