import { expect, test } from 'vitest';
import { pickCurve } from '../../../web/view/overlays/curves';
import type { Curve } from '../../../web/view/overlays/types';

const curve = (id: string, points: Curve['points'], plain = false): Curve => ({
  id,
  points,
  tint: 'blue',
  selected: false,
  plain,
});
const flat = ([x, y, z]: Curve['points'][number]) => ({ x, y, z });
const CURVES = [
  curve('a', [
    [0, 0, 1],
    [100, 0, 1],
    [200, 0, 1],
  ]),
  curve('b', [
    [50, 6, 1],
    [50, 90, 1],
  ]),
];

test('a control point in reach wins over a nearer line', () => {
  expect(pickCurve(CURVES, 50, 1, flat)).toEqual({ id: 'b', point: 0, segment: 0 });
});

test('between control points the line answers, with the piece that was met', () => {
  expect(pickCurve(CURVES, 150, 5, flat)).toEqual({ id: 'a', point: null, segment: 1 });
});

test('the last control point belongs to the last piece', () => {
  expect(pickCurve(CURVES, 203, 2, flat)).toEqual({ id: 'a', point: 2, segment: 1 });
});

test('nothing is met beside the curves, behind the eye, or on a plain line', () => {
  expect(pickCurve(CURVES, 150, 40, flat)).toBeNull();
  expect(pickCurve([curve('c', [[0, 0, -1]])], 0, 0, flat)).toBeNull();
  expect(pickCurve([curve('h', [[0, 0, 1]], true)], 0, 0, flat)).toBeNull();
});
