import { describe, expect, test } from 'vitest';
import { type MatchStep, newMatchStep } from '../../../web/recipe/steps/match';
import {
  curveFor,
  markerFor,
  missing,
  withMask,
  withModels,
  withoutCurve,
  withoutMarker,
  withPlace,
  withRow,
  withSharp,
} from '../../../web/tools/match/edits';

const EMPTY = newMatchStep('m', ['a', 'b']);
const marked = (...markers: MatchStep['markers']): MatchStep => ({ ...EMPTY, markers });

describe('markers', () => {
  test('a press on one model begins a marker, on the other completes it', () => {
    const begun = withPlace(EMPTY, markerFor(EMPTY, null, 0), 0, 7);
    expect(begun.markers).toEqual([[7, null]]);
    expect(missing(begun.markers[0]!)).toEqual([1]);
    const whole = withPlace(begun, markerFor(begun, 0, 1), 1, 9);
    expect(whole.markers).toEqual([[7, 9]]);
    expect(missing(whole.markers[0]!)).toEqual([]);
  });

  test('a press is for the selected marker only where that is not set yet', () => {
    const step = marked([1, null], [2, 3]);
    expect(markerFor(step, 0, 1)).toBe(0);
    expect(markerFor(step, 0, 0)).toBe(2);
    expect(markerFor(step, 1, 0)).toBe(2);
    expect(markerFor(step, null, 1)).toBe(2);
    expect(markerFor(step, 9, 1)).toBe(2);
  });

  test('one that is set nowhere is none', () => {
    expect(withPlace(marked([1, null]), 0, 0, null).markers).toEqual([]);
    expect(withoutMarker(marked([1, 2], [3, 4]), 0).markers).toEqual([[3, 4]]);
  });
});

describe('lines and masks', () => {
  const drawn = withRow(withRow(EMPTY, 0, 0, [1, 2, 3]), 0, 1, [4, 5]);

  test('a stroke is for the selected line until it is there on every model', () => {
    const begun = withRow(EMPTY, curveFor(EMPTY, null), 0, [1, 2]);
    expect(begun.curves).toEqual([[[1, 2], []]]);
    expect(curveFor(begun, 0)).toBe(0);
    expect(curveFor(drawn, 0)).toBe(1);
    expect(curveFor(begun, null)).toBe(1);
  });

  test('without any the step says nothing of them', () => {
    expect(withoutCurve(drawn, 0)).toEqual(EMPTY);
    const masked = withMask(EMPTY, 1, [3, 4]);
    expect(masked.mask).toEqual([[], [3, 4]]);
    expect(withMask(masked, 1, [])).toEqual(EMPTY);
    expect(withMask(EMPTY, 0, 'all').mask).toEqual(['all', []]);
  });
});

describe('picked edges', () => {
  test('are put in, changed and left by number; without any the step says nothing of them', () => {
    const one = withSharp(EMPTY, 1, 0, [3, 4, 5]);
    expect(one.sharp).toEqual([[], [[3, 4, 5]]]);
    const two = withSharp(withSharp(one, 1, 1, [7, 8]), 1, 0, [3, 4]);
    expect(two.sharp).toEqual([
      [],
      [
        [3, 4],
        [7, 8],
      ],
    ]);
    expect(withSharp(two, 1, 0, []).sharp).toEqual([[], [[7, 8]]]);
    expect(withSharp(withSharp(two, 1, 0, []), 1, 0, [])).toEqual(EMPTY);
  });
});

describe('other models', () => {
  const full: MatchStep = {
    ...withRow(withRow(marked([1, 2], [3, null]), 0, 0, [1, 2]), 0, 1, [4, 5]),
    mask: [[8], []],
    sharp: [[[1, 2]], []],
  };

  test('whatever is said of each goes with it into another order', () => {
    const turned = withModels(full, ['b', 'a'], [1, 0]);
    expect(turned).toMatchObject({
      models: ['b', 'a'],
      markers: [
        [2, 1],
        [null, 3],
      ],
      curves: [
        [
          [4, 5],
          [1, 2],
        ],
      ],
      mask: [[], [8]],
      sharp: [[], [[1, 2]]],
    });
    expect(withModels(turned, ['a', 'b'], [1, 0])).toEqual(full);
  });

  test('on a new one nothing is marked; what only one had that is gone, goes', () => {
    expect(withModels(full, ['a', 'b', 'c'], [0, 1, null])).toMatchObject({
      markers: [
        [1, 2, null],
        [3, null, null],
      ],
      curves: [[[1, 2], [4, 5], []]],
      mask: [[8], [], []],
    });
    expect(withModels(full, ['c', 'b'], [null, 1]).markers).toEqual([[null, 2]]);
  });
});
