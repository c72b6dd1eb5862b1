import { expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { crossings } from './triangle-crossings';

/** Two triangles; the second is moved along z. */
const pair = (z: number): Model => ({
  name: 'pair',
  positions: Float64Array.from([0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1 + z, 1.2, 1, 1 + z, 1, 1.2, 1 + z]),
  faceOffsets: Uint32Array.of(0, 3, 6),
  faceVertices: Uint32Array.of(0, 1, 2, 3, 4, 5),
});

test('triangles that pass through one another are found, near ones are not', () => {
  const all = new Set([0, 1, 2, 3, 4, 5]);
  expect(crossings(pair(0), all)).toEqual([
    [0, 1],
    [1, 0],
  ]);
  expect(crossings(pair(0), new Set([4]))).toEqual([[1, 0]]);
  expect(crossings(pair(1.01), all)).toEqual([]);
  expect(crossings(pair(-1.01), all)).toEqual([]);
});
