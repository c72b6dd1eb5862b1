import { expect, test } from 'vitest';
import { product, type Quaternion, quaternionOf, rotated, unitQuaternion } from '../../web/core/quaternion';

const AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;

const TURNS: readonly Quaternion[] = [
  [0, 0, 0, 1],
  [1, 0, 0, 0],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  unitQuaternion([1, 2, 3, 4]),
  unitQuaternion([-5, 1, 0.5, 0.2]),
  unitQuaternion([0.1, -3, 1, 0]),
];

const close = (a: readonly number[], b: readonly number[]) =>
  expect(a).toEqual(b.map((x) => expect.closeTo(x, 12)));

test.each(TURNS)('%d %d %d %d is that of its own matrix, up to its sign', (...turn) => {
  const columns = AXES.map((axis) => rotated(turn, axis));
  const back = quaternionOf((row, column) => columns[column]![row]!);
  const sign = Math.sign(back.reduce((sum, x, k) => sum + x * turn[k]!, 0));
  close(
    back.map((x) => sign * x),
    turn,
  );
});

test('lengths and angles stay, and a quarter turn goes the right way round', () => {
  const quarter: Quaternion = [0, 0, Math.SQRT1_2, Math.SQRT1_2];
  close(rotated(quarter, [1, 0, 0]), [0, 1, 0]);
  for (const turn of TURNS) expect(Math.hypot(...rotated(turn, [3, -1, 2]))).toBeCloseTo(Math.sqrt(14), 12);
});

test('a product turns by the second, then by the first', () => {
  for (const a of TURNS)
    for (const b of TURNS) close(rotated(product(a, b), [1, -2, 0.5]), rotated(a, rotated(b, [1, -2, 0.5])));
});
