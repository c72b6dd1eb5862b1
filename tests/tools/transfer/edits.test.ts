import { expect, test } from 'vitest';
import { holds } from '../../../web/core/vertex-set';
import { newTransferStep } from '../../../web/recipe/steps/transfer';
import { counterpartAt, nextOpen, pairing, setCounterpart } from '../../../web/tools/transfer/edits';
import { region } from './chair';

const step = {
  ...newTransferStep('t', 'm', 'p', 3),
  handles: [[1, 2], { ranges: [[5, 9]] }, []],
} as ReturnType<typeof newTransferStep>;

test('a set holds its vertices however it is written', () => {
  expect([holds('all', 7), holds([1, 7], 7), holds([1, 8], 7)]).toEqual([true, true, false]);
  expect([4, 5, 9, 10].map((v) => holds({ ranges: [[5, 9]] }, v))).toEqual([false, true, true, false]);
  expect([2, 7, 4].map((v) => counterpartAt(step, v))).toEqual([0, 1, -1]);
});

test('a new counterpart takes its vertices from the others, which stay the same objects otherwise', () => {
  const next = setCounterpart(step, 2, Uint32Array.of(6, 7), 20);
  expect(next.handles).toEqual([
    [1, 2],
    [5, 8, 9],
    [6, 7],
  ]);
  expect(next.handles[0]).toBe(step.handles[0]);
});

test('a pair needs both of its sides', () => {
  const handles = [region(1), region(), region(2)];
  expect(pairing(step, handles)).toEqual({ paired: [0], open: [1, 2] });
  // As many as the pose has by now, not as many as were paired.
  expect(pairing(step, [...handles, region(3)])).toEqual({ paired: [0], open: [1, 2, 3] });
});

test('the next open one comes after, then around the end', () => {
  expect([null, 0, 1, 4].map((after) => nextOpen([1, 4], after))).toEqual([1, 1, 4, 1]);
  expect(nextOpen([], 2)).toBeNull();
});
