import { expect, test } from 'vitest';
import { pickLine } from '../../../web/view/overlays/control-lines';
import type { ControlLine } from '../../../web/view/overlays/types';

const line = (id: string, points: ControlLine['points'], plain = false): ControlLine => ({
  id,
  points,
  tint: 'blue',
  selected: false,
  plain,
});
const flat = ([x, y, z]: ControlLine['points'][number]) => ({ x, y, z });
const LINES = [
  line('a', [
    [0, 0, 1],
    [100, 0, 1],
    [200, 0, 1],
  ]),
  line('b', [
    [50, 6, 1],
    [50, 90, 1],
  ]),
];

test('a control point in reach wins over a nearer line', () => {
  expect(pickLine(LINES, 50, 1, flat)).toEqual({ id: 'b', point: 0, segment: 0 });
});

test('between control points the line answers, with the piece that was met', () => {
  expect(pickLine(LINES, 150, 5, flat)).toEqual({ id: 'a', point: null, segment: 1 });
});

test('the last control point belongs to the last piece', () => {
  expect(pickLine(LINES, 203, 2, flat)).toEqual({ id: 'a', point: 2, segment: 1 });
});

test('nothing is met beside the lines, behind the eye, or on a plain line', () => {
  expect(pickLine(LINES, 150, 40, flat)).toBeNull();
  expect(pickLine([line('c', [[0, 0, -1]])], 0, 0, flat)).toBeNull();
  expect(pickLine([line('h', [[0, 0, 1]], true)], 0, 0, flat)).toBeNull();
});

test('a smooth line is met where it runs, and says which control points it is between', () => {
  const bent = { ...LINES[0]!, smooth: [0, 50, 100, 150, 200].map((x) => [x, x % 100 ? 40 : 0, 1] as const) };
  expect(pickLine([bent], 150, 38, flat)).toEqual({ id: 'a', point: null, segment: 1 });
  expect(pickLine([bent], 150, 1, flat)).toBeNull();
});
