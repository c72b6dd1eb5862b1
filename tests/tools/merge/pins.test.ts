import { expect, test } from 'vitest';
import {
  addKey,
  type MergeBoundary,
  moveKey,
  partnerOf,
  pinsOf,
  removeKey,
  withFoundKeys,
} from '../../../web/tools/merge/pins';

/** Rings of n vertices 0 … n − 1; the target's runs against the source's where they meet. */
const ring = (n: number): Float64Array =>
  Float64Array.from({ length: 3 * n }, (_, i) => {
    const angle = (2 * Math.PI * Math.floor(i / 3)) / n;
    return [Math.cos(angle), Math.sin(angle), 0][i % 3]!;
  });
const upTo = (n: number) => Array.from({ length: n }, (_, i) => i);
const positions = { source: ring(12), target: ring(24) };
const boundary = (...keys: [number, number][]): MergeBoundary => ({
  source: upTo(12),
  target: upTo(24),
  keys,
  sourceKeep: [],
  targetKeep: [],
});

test('pins are numbered through, found ones where a boundary has none of its own', () => {
  const pins = pinsOf(
    [boundary([1, 2]), boundary()],
    [
      [[9, 9]],
      [
        [3, 4],
        [5, 6],
      ],
    ],
  );
  expect(pins.map(({ number, boundary: at, key, vertices }) => [number, at, key, ...vertices])).toEqual([
    [0, 0, 0, 1, 2],
    [1, 1, 0, 3, 4],
    [2, 1, 1, 5, 6],
  ]);
  const written = withFoundKeys([boundary([1, 2]), boundary()], [[[9, 9]], [[3, 4]]]);
  expect(written.map(({ keys }) => keys)).toEqual([[[1, 2]], [[3, 4]]]);
});

test('the partner of a vertex lies as far along the other loop, which runs the other way', () => {
  expect(partnerOf(boundary([0, 0]), 'source', 3, positions)).toBe(18);
  expect(partnerOf(boundary([0, 0]), 'target', 18, positions)).toBe(3);
  expect(partnerOf(boundary([0, 0], [6, 16]), 'source', 3, positions)).toBe(20);
});

test('a pin that is added keeps all pins in the same order around both loops', () => {
  let now = boundary([0, 0]);
  for (const vertex of [7, 3, 10]) now = addKey(now, 'source', vertex, positions);
  expect(now.keys).toEqual([
    [0, 0],
    [3, 18],
    [7, 10],
    [10, 4],
  ]);
  expect(addKey(now, 'source', 7, positions)).toBe(now);
});

test('a pin that is dragged follows the loop, the short way over its start too', () => {
  expect(moveKey(boundary([1, 5]), 0, 'source', 11).keys).toEqual([[11, 5]]);
  expect(moveKey(boundary([1, 5]), 0, 'target', 20).keys).toEqual([[1, 20]]);
  expect(moveKey(boundary([1, 5]), 0, 'target', 99).keys).toEqual([[1, 5]]);
});

test('a pin stops beside its neighbours instead of passing them', () => {
  const three = boundary([0, 0], [4, 16], [8, 8]);
  expect(moveKey(three, 1, 'source', 9).keys[1]).toEqual([7, 16]);
  expect(moveKey(three, 1, 'source', 8).keys[1]).toEqual([7, 16]);
  expect(moveKey(three, 1, 'source', 0).keys[1]).toEqual([1, 16]);
  expect(moveKey(three, 1, 'source', 6).keys[1]).toEqual([6, 16]);
});

test('a pin that is taken away leaves the others alone', () => {
  expect(removeKey(boundary([0, 0], [4, 16]), 0).keys).toEqual([[4, 16]]);
});
