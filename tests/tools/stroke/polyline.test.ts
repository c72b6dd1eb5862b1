import fc from 'fast-check';
import { expect, test } from 'vitest';
import { numerator } from '../../../web/core/decimal';
import { gap } from '../../../web/tools/geometry';
import {
  crossing,
  from,
  joined,
  lengthOf,
  nearestOn,
  placesFor,
  quantised,
  resampled,
  smoothed,
  thinned,
  upTo,
} from '../../../web/tools/stroke/polyline';
import type { Vec3 } from '../../../web/view/types';

const point = fc.tuple(
  fc.double({ min: -10, max: 10, noNaN: true }),
  fc.double({ min: -10, max: 10, noNaN: true }),
  fc.double({ min: -10, max: 10, noNaN: true }),
);
const line = fc.array(point, { minLength: 2, maxLength: 12 }).filter((points) => lengthOf(points) > 1);

test('a resampled line keeps its ends and walks the old one in equal steps', () => {
  fc.assert(
    fc.property(line, fc.double({ min: 0.05, max: 5, noNaN: true }), (points, step) => {
      const even = resampled(points, step);
      expect(even[0]).toEqual(points[0]);
      expect(even.at(-1)).toEqual(points.at(-1));
      const arc = lengthOf(points) / (even.length - 1);
      if (even.length > 2) expect(Math.abs(arc - step)).toBeLessThanOrEqual(step / 2 + 1e-9);
      for (const each of even) expect(nearestOn(points, each)!.distance).toBeLessThan(1e-9);
      for (const [i, each] of even.slice(1).entries())
        expect(gap(each, even[i]!)).toBeLessThanOrEqual(arc + 1e-9);
    }),
  );
});

test('smoothing leaves a straight line of even steps and the ends of any line where they are', () => {
  const straight: Vec3[] = [0, 1, 2, 3, 4].map((x) => [x, 2 * x, 0]);
  expect(smoothed(straight, 7)).toEqual(straight);
  fc.assert(
    fc.property(line, (points) => {
      const even = smoothed(points, 5);
      expect([even[0], even.at(-1)]).toEqual([points[0], points.at(-1)]);
      expect(lengthOf(even)).toBeLessThanOrEqual(lengthOf(points) + 1e-9);
    }),
  );
});

test('a line cut in two at a place and joined again is the line it was', () => {
  fc.assert(
    fc.property(line, point, (points, to) => {
      const place = nearestOn(points, to)!;
      const again = joined(upTo(points, place), from(points, place));
      expect(lengthOf(again)).toBeCloseTo(lengthOf(points), 9);
      expect([again[0], again.at(-1)]).toEqual([points[0], points.at(-1)]);
    }),
  );
});

test('stored points are exact decimals, however large the head', () => {
  for (const size of [0.0027, 0.27, 2.7, 27, 270, 2.7e6]) {
    const places = placesFor(size);
    const [stored] = quantised([[size / 3, -size / 7, 0.12345 * size]], places);
    for (const [k, x] of stored!.entries()) {
      expect(numerator(x, places)).toBeDefined();
      expect(Math.abs(x - [size / 3, -size / 7, 0.12345 * size][k]!)).toBeLessThan(size / 200);
    }
  }
});

test('points that become one by rounding are stored once', () => {
  expect(quantised([[0, 0, 0], [0.0004, 0, 0], [1, 0, 0]], 3)).toEqual([[0, 0, 0], [1, 0, 0]]); // biome-ignore format: short
});

test('thinning keeps the ends and a distance between the rest', () => {
  const crowded: Vec3[] = [0, 0.1, 0.2, 1, 1.05, 2, 2.9, 3].map((x) => [x, 0, 0]);
  expect(thinned(crowded, 0.5).map(([x]) => x)).toEqual([0, 1, 2, 3]);
});

test('lines cross where they cross, and lines beside each other do not', () => {
  const across = crossing([[0, -1, 0], [0, 1, 0]], [[-1, 0, 0], [1, 0, 0], [2, 0, 0]]); // biome-ignore format: short
  expect(across!.onB).toMatchObject({ segment: 0, t: 0.5 });
  expect(crossing([[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0]])).toBeUndefined(); // biome-ignore format: short
});
