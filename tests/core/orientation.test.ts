import { expect, test } from 'vitest';
import { orientationBetween } from '../../web/core/orientation';
import { rotated, unitQuaternion } from '../../web/core/quaternion';

/** Of points that are turned and made `scale` times as large. */
function moments(points: readonly (readonly [number, number, number])[], turn: typeof TURN, scale: number) {
  const sums = new Float64Array(9);
  for (const p of points) {
    const q = rotated(turn, p);
    for (let j = 0; j < 3; j++) for (let k = 0; k < 3; k++) sums[3 * j + k]! += p[j]! * scale * q[k]!;
  }
  return sums;
}

const TURN = unitQuaternion([0.3, -0.7, 0.2, 0.5]);
const POINTS = [
  [1, 0, 0],
  [0, 2, 0],
  [0, 0, 3],
  [1, 1, -1],
] as const;

test('the turn between points is found, and how much better it is than any other', () => {
  const { rotation, largest, next } = orientationBetween(moments(POINTS, TURN, 10));
  const side = Math.sign(rotation[3] * TURN[3]);
  for (const [k, x] of rotation.entries()) expect(side * x).toBeCloseTo(TURN[k]!, 12);
  const size = POINTS.flat().reduce((sum: number, x) => sum + x * x, 0);
  expect(largest).toBeCloseTo(10 * size, 9);
  expect(next).toBeLessThan(0.9 * largest);
});

test('points of a line leave it open', () => {
  const line = [-1, 1, 3].map((x) => [x, 2 * x, 0] as const);
  const { largest, next } = orientationBetween(moments(line, TURN, 1));
  expect(largest - next).toBeLessThan(1e-12 * largest);
});
