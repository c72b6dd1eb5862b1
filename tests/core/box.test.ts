import { expect, test } from 'vitest';
import { boxOf, middleOf, sizeOf } from '../../web/core/box';

test('the box holds every place, and touches some on each side', () => {
  const box = boxOf(Float64Array.of(1, 5, -2, 3, 4, 0, 2, 9, -7));
  expect(box).toEqual({ low: [1, 4, -7], high: [3, 9, 0] });
  expect(middleOf(box)).toEqual([2, 6.5, -3.5]);
  expect(sizeOf(box)).toEqual([2, 5, 7]);
});

test('coordinates that are not finite are left out, the others of their place are not', () => {
  expect(boxOf([1, Number.NaN, 3, 2, 5, Infinity])).toEqual({ low: [1, 5, 3], high: [2, 5, 3] });
});

test('nothing has a box without inside', () => {
  expect(sizeOf(boxOf([]))).toEqual([-Infinity, -Infinity, -Infinity]);
});
