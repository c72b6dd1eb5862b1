// Pieces of schema that several step types share.

import * as v from 'valibot';

export const finite = v.pipe(v.number(), v.finite('a finite number'));
export const index = v.pipe(v.number(), v.integer('a whole number'), v.minValue(0, 'an index from 0 on'));

/** A reference to a model or to an earlier step. */
export const reference = v.pipe(v.string(), v.minLength(1), v.maxLength(64));

export const stepId = v.pipe(v.string(), v.minLength(1), v.maxLength(64));

export const vec3 = v.tuple([finite, finite, finite]);

/** 16 numbers, column-major, applied to rest positions; affine: the last row is 0 0 0 1. */
export const matrix = v.pipe(
  v.array(finite),
  v.length(16, 'a matrix of 16 numbers'),
  v.check((m) => m[3] === 0 && m[7] === 0 && m[11] === 0 && m[15] === 1, 'a matrix whose last row is 0 0 0 1'),
);

export const vertexSet = v.union(
  [
    v.literal('all'),
    v.array(index),
    v.strictObject({
      ranges: v.array(
        v.pipe(
          v.tuple([index, index]),
          v.check(([first, last]) => first <= last, 'a range whose first is not after its last'),
        ),
      ),
    }),
  ],
  '"all", a list of indices, or { "ranges": [[first, last], ...] }',
);
