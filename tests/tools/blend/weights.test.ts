import { describe, expect, test } from 'vitest';
import {
  normalised,
  type Point,
  placeOf,
  sharesAt,
  sharing,
  sumOf,
  withShares,
} from '../../../web/tools/blend/weights';

const NAMES = ['a', 'b', 'c', 'd'];
const CORNERS: readonly [Point, Point, Point] = [
  { x: 100, y: 0 },
  { x: 200, y: 150 },
  { x: 0, y: 150 },
];

describe('a weight that moves makes room', () => {
  test('the others keep their ratio, and all sum to 1', () => {
    const next = sharing({ a: 0.4, b: 0.4, c: 0.2, d: 0 }, NAMES, 'a', 0.7);
    expect(next).toEqual({ a: 0.7, b: 0.2, c: 0.1, d: 0 });
    expect(sumOf(next)).toBeCloseTo(1, 12);
  });

  test('others that were nothing get as much each', () => {
    expect(sharing({ a: 1 }, ['a', 'b', 'c'], 'a', 0.5)).toEqual({ a: 0.5, b: 0.25, c: 0.25 });
  });

  test('beyond all of one the others are taken away', () => {
    expect(sharing({ a: 1, b: 0 }, ['a', 'b'], 'a', 1.3)).toEqual({ a: 1.3, b: -0.3 });
  });

  test.each([1 / 3, 0.123456, 0.9999, -0.2])('rounded they still sum to 1, at %f', (value) => {
    const next = sharing({ a: 1, b: 2, c: 3, d: 5 }, NAMES, 'b', value);
    expect(Math.abs(sumOf(next) - 1)).toBeLessThan(1e-9);
  });
});

test('weights are scaled to a whole, or shared out where there is nothing to scale', () => {
  expect(normalised({ a: 2, b: 2 }, ['a', 'b'])).toEqual({ a: 0.5, b: 0.5 });
  expect(normalised({}, ['a', 'b', 'c', 'd'])).toEqual({ a: 0.25, b: 0.25, c: 0.25, d: 0.25 });
  expect(sumOf(normalised({}, ['a', 'b', 'c']))).toBeCloseTo(1, 12);
});

describe('a dot in a triangle', () => {
  test('is where its shares say, and back', () => {
    const shares = [0.5, 0.2, 0.3] as [number, number, number];
    const back = sharesAt(CORNERS, placeOf(CORNERS, shares));
    for (const [k, share] of back.entries()) expect(share).toBeCloseTo(shares[k]!, 12);
  });

  test('at a corner it is all of one', () => {
    for (const k of [0, 1, 2]) {
      const shares = sharesAt(CORNERS, CORNERS[k]!);
      for (const [at, share] of shares.entries()) expect(share).toBeCloseTo(at === k ? 1 : 0, 12);
    }
  });

  test('outside it is brought to the nearest place of the edge', () => {
    expect(sharesAt(CORNERS, { x: 100, y: 400 })).toEqual([0, 0.5, 0.5]);
    expect(sharesAt(CORNERS, { x: 100, y: -50 })).toEqual([1, 0, 0]);
    expect(sharesAt(CORNERS, { x: 500, y: 160 })).toEqual([0, 1, 0]);
  });

  test('weights beyond the triangle are shown on its edge', () => {
    const { x, y } = placeOf(CORNERS, [1.5, -0.5, 0]);
    expect([x, y]).toEqual([100, 0]);
  });

  test('shares what the models that are no corner leave', () => {
    const next = withShares({ d: 0.4 }, NAMES, ['a', 'b', 'c'], [0.5, 0.5, 0]);
    expect(next).toEqual({ a: 0.3, b: 0.3, c: 0, d: 0.4 });
  });
});
