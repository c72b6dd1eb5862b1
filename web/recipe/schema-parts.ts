// Pieces of schema that several step types share. Each custom message is what was expected, as it reads after
// "expected": the sentence around it is made in problem.ts.

import * as v from 'valibot';
import { MAX_COORDINATE } from './limits';

export const index = v.pipe(
  v.number(),
  v.integer('a whole number'),
  v.minValue(0, 'an index from 0 on'),
  v.maxValue(Number.MAX_SAFE_INTEGER, 'an index below 2^53'),
);

export const list = <const S extends v.GenericSchema>(item: S) => v.array(item, 'a list');

/** A list that is refused for its length before any of its items is looked at. */
export function listUpTo<const S extends v.GenericSchema>(
  most: number,
  item: S,
  expected = `a list of at most ${grouped(most)}`,
) {
  const bounded = v.pipe(list(item), v.maxLength(most, expected));
  const door = v.pipe(v.array(v.unknown()), v.maxLength(most, expected));
  const isLong = (value: unknown) => Array.isArray(value) && value.length > most;
  const run: (typeof bounded)['~run'] = (dataset, config) =>
    (isLong(dataset.value) ? (door as unknown as typeof bounded) : bounded)['~run'](dataset, config);
  return { ...bounded, '~run': run };
}

/** A number with both ends; there is no other kind in a recipe. */
export function between(low: number, high: number) {
  const expected = `a number from ${low} to ${high}`;
  return v.pipe(v.number(), v.minValue(low, expected), v.maxValue(high, expected));
}

export function positiveUpTo(high: number) {
  const expected = `a number above 0, up to ${high}`;
  return v.pipe(v.number(), v.gtValue(0, expected), v.maxValue(high, expected));
}

export function wholeBetween(low: number, high: number) {
  const expected = `a whole number from ${grouped(low)} to ${grouped(high)}`;
  return v.pipe(v.number(), v.integer(expected), v.minValue(low, expected), v.maxValue(high, expected));
}

export const grouped = (n: number): string => n.toLocaleString('en-US');

/** In model units. */
export const coordinate = between(-MAX_COORDINATE, MAX_COORDINATE);
export const length = positiveUpTo(MAX_COORDINATE);

/** A reference to a model or to an earlier step; found by identity when references are checked. */
export const reference = modelName();

/** A reference to an earlier step that leaves several models, for all of them; found by identity as well. */
export const severalReference = modelName();

/** Long enough for the models of a step that started from those of another. */
function modelName() {
  return v.pipe(v.string(), v.minLength(1, 'a name'), v.maxLength(200, 'a name of at most 200 characters'));
}

/** One of the models that a `severalReference` stands for, as the step that leaves them calls it. */
export const memberName = modelName();

/** What a person calls something. */
export const itemName = v.pipe(v.string(), v.maxLength(64, 'a name of at most 64 characters'));

export const stepId = v.pipe(
  v.string(),
  v.minLength(1, 'an id'),
  v.maxLength(64, 'an id of at most 64 characters'),
);

export const fileName = v.pipe(
  v.string(),
  v.minLength(1, 'a file name'),
  v.maxLength(255, 'a file name of at most 255 characters'),
  // "D:x.ply" is a place that depends on the machine and on what was done there before.
  v.regex(/^(?![A-Za-z]:)/, 'a file name without a drive such as "D:"'),
);

export const vec3 = v.strictTuple([coordinate, coordinate, coordinate], 'three numbers');

/** 16 numbers, column-major, applied to rest positions; affine: the last row is 0 0 0 1. */
export const matrix = v.pipe(
  list(coordinate),
  v.length(16, 'a matrix of 16 numbers'),
  v.check(
    (m) => m[3] === 0 && m[7] === 0 && m[11] === 0 && m[15] === 1,
    'a matrix whose last row is 0 0 0 1',
  ),
);

const VERTEX_SET = '"all", a list of indices, or { "ranges": [[first, last], ...] }';

export const vertexSet = v.union(
  [
    v.literal('all'),
    list(index),
    v.strictObject({
      ranges: list(
        v.pipe(
          v.strictTuple([index, index], 'a pair of indices'),
          v.check(([first, last]) => first <= last, 'a range whose first is not after its last'),
        ),
      ),
    }),
  ],
  oneOf(['ranges'], VERTEX_SET),
);

/** Message of a union of objects told apart by their fields: names a field that none of them has. */
export function oneOf(fields: readonly string[], expected: string) {
  return ({ input }: { readonly input: unknown }): string => {
    const given =
      input !== null && typeof input === 'object' && !Array.isArray(input) ? Object.keys(input) : [];
    const unknown = given.find((field) => !fields.includes(field));
    return unknown === undefined ? expected : `${expected} without the field "${unknown}"`;
  };
}
