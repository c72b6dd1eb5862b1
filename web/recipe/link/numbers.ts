// Numbers, each bit for bit, in as few bytes as their digits ask for. What tools store has few decimals
// (core/decimal), so it is written as integers; differences of neighbours make those small.

import { fromDecimal, numerator } from '../../core/decimal';
import { type ByteReader, type ByteWriter, zigzagLength } from './bytes';
import { damaged } from './errors';

// First byte of a single number: 0–22 are the decimal places of the integer that follows.
const MAX_PLACES = 22;
const FLOAT32 = 23;
const FLOAT64 = 24;
const NEGATIVE_ZERO = 25;
/** From here on the byte itself is a small integer. */
const SMALL = 32;
const SMALLEST = -32;

export function writeNumber(out: ByteWriter, value: number): void {
  const places = placesOf(value);
  const whole = places === undefined ? 0 : numerator(value, places)!;
  const single = Math.fround(value) === value;
  if (Object.is(value, -0)) out.byte(NEGATIVE_ZERO);
  else if (places === 0 && whole >= SMALLEST && whole < SMALLEST + 256 - SMALL)
    out.byte(whole - SMALLEST + SMALL);
  else if (places !== undefined && zigzagLength(whole) <= (single ? 4 : 8)) {
    out.byte(places);
    out.zigzag(whole);
  } else if (single) {
    out.byte(FLOAT32);
    out.float32(value);
  } else {
    out.byte(FLOAT64);
    out.float64(value);
  }
}

export function readNumber(from: ByteReader): number {
  const kind = from.byte();
  if (kind >= SMALL) return kind - SMALL + SMALLEST;
  if (kind <= MAX_PLACES) return fromDecimal(from.zigzag(), kind);
  if (kind === NEGATIVE_ZERO) return -0;
  if (kind !== FLOAT32 && kind !== FLOAT64) throw damaged();
  return finite(kind === FLOAT32 ? from.float32() : from.float64());
}

const EACH_ALONE = 31;

/**
 * Numbers that follow each other, `width` to a row (1 for a plain list). Either each alone, or all with the same
 * decimal places as differences: of order 0, 1 or 2, from the number before or from the one above in its column.
 */
export function writeNumbers(out: ByteWriter, values: readonly number[], width: number): void {
  const places = commonPlaces(values);
  if (places === undefined) {
    out.byte(EACH_ALONE);
    for (const value of values) writeNumber(out, value);
    return;
  }
  const whole = values.map((value) => numerator(value, places)!);
  const schemes = width === 1 ? [0, 1, 2] : [0, 1, 2, 3, 4];
  const candidates = schemes.map((scheme) => differences(whole, scheme, width));
  const lengths = candidates.map((each) => each.reduce((sum, value) => sum + zigzagLength(value), 0));
  const best = lengths.indexOf(Math.min(...lengths));
  out.byte(places);
  out.byte(best);
  for (const value of candidates[best]!) out.zigzag(value);
}

export function readNumbers(from: ByteReader, count: number, width: number): number[] {
  if (count > from.left) throw damaged();
  const places = from.byte();
  if (places === EACH_ALONE) return Array.from({ length: count }, () => readNumber(from));
  const scheme = from.byte();
  if (places > MAX_PLACES || scheme > 4) throw damaged();
  const values = Array.from({ length: count }, () => from.zigzag());
  const [order, stride] = shape(scheme, width);
  for (let pass = 0; pass < order; pass++)
    for (let i = stride; i < count; i++) values[i] = values[i]! + values[i - stride]!;
  return values.map((value) => finite(fromDecimal(value, places)));
}

/** Order and stride of a difference scheme. */
const shape = (scheme: number, width: number): readonly [number, number] =>
  scheme < 3 ? [scheme, 1] : [scheme - 2, width];

function differences(values: readonly number[], scheme: number, width: number): number[] {
  const [order, stride] = shape(scheme, width);
  const out = [...values];
  for (let pass = 0; pass < order; pass++)
    for (let i = out.length - 1; i >= stride; i--) out[i] = out[i]! - out[i - stride]!;
  return out;
}

/** The fewest decimals that give the number back bit for bit. */
function placesOf(value: number): number | undefined {
  for (let places = 0; places <= MAX_PLACES; places++)
    if (numerator(value, places) !== undefined) return places;
  return undefined;
}

/** Decimals that all the numbers share, unless one of them has none or they would be longer than alone. */
function commonPlaces(values: readonly number[]): number | undefined {
  let most = 0;
  for (const value of values) {
    const places = placesOf(value);
    if (places === undefined) return undefined;
    most = Math.max(most, places);
  }
  return values.every((value) => numerator(value, most) !== undefined) ? most : undefined;
}

function finite(value: number): number {
  if (!Number.isFinite(value)) throw damaged();
  return value;
}
