// Numbers that a person, a file and a link can all hold in a few digits.

const POWERS = Array.from({ length: 23 }, (_, k) => Number(`1e${k}`));

/** Numerators beyond this are not worth a decimal: a plain double is as short. */
export const MAX_NUMERATOR = 2 ** 49;

/**
 * `value · 10^places` if it is an integer whose division by `10^places` gives `value` back bit for bit, else
 * `undefined`. Both are exact doubles for up to 22 places, so the division is the decimal's nearest double.
 */
export function numerator(value: number, places: number): number | undefined {
  const scaled = Math.round(value * POWERS[places]!);
  // −0 is no integer; comparing by division finds it equal to itself, so it is refused by name.
  if (Math.abs(scaled) > MAX_NUMERATOR || Object.is(scaled, -0)) return undefined;
  return fromDecimal(scaled, places) === value ? scaled : undefined;
}

/** The double nearest to `integer / 10^places`. */
export const fromDecimal = (integer: number, places: number): number => integer / POWERS[places]!;

/** The nearest number with at most `places` decimals: what tools store, so that documents and links stay short. */
export function roundTo(value: number, places: number): number {
  const rounded = fromDecimal(Math.round(value * POWERS[places]!), places);
  return Number.isFinite(rounded) ? rounded + 0 : value;
}
