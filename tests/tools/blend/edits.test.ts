import { expect, test } from 'vitest';
import { newBlendStep } from '../../../web/recipe/steps/blend';
import {
  addedMeasures,
  addedPart,
  partAt,
  wanting,
  withMeasure,
  withoutMeasure,
  withPart,
  withVertices,
} from '../../../web/tools/blend/edits';

const part = (vertices: number[]) => ({ from: 'b', vertices, feather: 0.1, how: 'paste' as const });
const start = () => newBlendStep('blend 1', 'match 1', ['a', 'b']);

test('a blend begins with as much of each', () => {
  expect(start()).toMatchObject({ weights: { a: 0.5, b: 0.5 }, parts: [], measures: [] });
});

test('the part that was painted last lies on top', () => {
  const step = addedPart(addedPart(start(), part([1, 2, 3])), part([3, 4]));
  expect([1, 3, 4, 5].map((v) => partAt(step, v))).toEqual([0, 1, 1, -1]);
});

test('a part keeps what it is called when its vertices change; erased to nothing it is gone', () => {
  const step = withPart(addedPart(start(), part([1, 2])), 0, { name: 'Nose' });
  const more = withVertices(step, 0, Uint32Array.of(1, 2, 7), 10);
  expect(more.parts).toEqual([{ ...part([1, 2, 7]), name: 'Nose' }]);
  expect(withVertices(more, 0, new Uint32Array(), 10).parts).toEqual([]);
});

test('a measure that is let go is only measured', () => {
  const held = wanting({ kind: 'height', up: [0, 1, 0] }, 2);
  expect(held).toEqual({ kind: 'height', up: [0, 1, 0], value: 2 });
  const step = addedMeasures(start(), [held]);
  const free = withMeasure(step, 0, wanting(step.measures[0]!, undefined));
  expect(free.measures[0]).not.toHaveProperty('value');
  expect(withoutMeasure(free, 0).measures).toEqual([]);
});
