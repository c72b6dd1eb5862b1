import { expect, test } from 'vitest';
import { pack, unpack } from '../../../web/view/hair/quantise';
import { resample } from '../../../web/view/hair/resample';
import { ViewSpace } from '../../../web/view/view-space';
import { straight, strandsOf } from './strands';

const at = (points: Float32Array, i: number): number[] => [...points.subarray(3 * i, 3 * i + 3)];

test('strands that all have the same number of points keep every one', () => {
  const strands = strandsOf([
    [
      [0, 0, 0],
      [1, 3, 0],
      [2, 0, 5],
    ],
    [
      [4, 0, 0],
      [5, 1, 0],
      [7, 2, 2],
    ],
  ]);
  const even = resample(strands, ViewSpace.identity);
  expect(even.perStrand).toBe(3);
  expect([...even.points]).toEqual([...strands.points]);
});

test('a shorter strand gets more points on the same line, and keeps both ends', () => {
  const even = resample(
    strandsOf([straight([0, 0, 0], [0, -8, 0], 9), straight([1, 0, 0], [1, 0, 2], 2)]),
    ViewSpace.identity,
  );
  expect(even.perStrand).toBe(9);
  for (let i = 0; i < 9; i++) expect(at(even.points, 9 + i)).toEqual([1, 0, i / 4]);
});

test('a strand of one point or with a broken number has no length, and does not widen the box', () => {
  const even = resample(
    strandsOf([
      straight([0, 0, 0], [1, 1, 1], 4),
      [[0.5, 0.5, 0.5]],
      [
        [0, 0, 0],
        [Number.NaN, 9, 9],
      ],
    ]),
    ViewSpace.identity,
  );
  for (const s of [1, 2]) {
    for (let i = 1; i < 4; i++) expect(at(even.points, 4 * s + i)).toEqual(at(even.points, 4 * s));
  }
  expect([even.low, even.high]).toEqual([
    [0, 0, 0],
    [1, 1, 1],
  ]);
});

test('far from the origin nothing is lost', () => {
  const shift = 1e7;
  const near = strandsOf([straight([0, 0, 0], [1, 2, 3], 5)]);
  const far = { ...near, origin: [shift, shift, shift] as const };
  const around = (low: number): ViewSpace =>
    ViewSpace.around({ positions: Float64Array.of(low, low, low, low + 4, low + 4, low + 4) });
  const [a, b] = [resample(near, around(0)), resample(far, around(shift))];
  expect([...b.points]).toEqual([...a.points]);
});

test('z-up strands stand upright', () => {
  const space = ViewSpace.around({ positions: Float64Array.of(-1, -1, -1, 1, 1, 1), upAxis: 'z' });
  const even = resample(strandsOf([straight([0, 0, 0], [0, 0, 1], 2)]), space);
  expect(at(even.points, 1)[1]).toBeCloseTo(space.scale);
});

test('points come back from the texture within half a step of the box', () => {
  const lines = Array.from({ length: 40 }, (_, s) =>
    straight([Math.sin(s), Math.cos(s), s / 40], [3 * Math.sin(2 * s), -2, Math.cos(3 * s)], 7),
  );
  const even = resample(strandsOf(lines), ViewSpace.identity);
  const packed = pack(even);
  for (let i = 0; i < 40 * 7; i++) {
    const back = unpack(packed, i);
    back.forEach((value, k) => {
      expect(Math.abs(value - even.points[3 * i + k]!)).toBeLessThanOrEqual(
        (0.5001 * packed.size[k]!) / 65535,
      );
    });
  }
});

test('no strands make an empty texture of one row', () => {
  const packed = pack(resample(strandsOf([]), ViewSpace.identity));
  expect(packed.rows).toBe(1);
});
