import { expect, test } from 'vitest';
import { dragged, type PlanePoint, placed } from '../../../web/tools/merge/placement';

const from = { shift: [1, 2], turn: 30, scale: 0.5 } as const;

const close = ([x, y]: PlanePoint, [a, b]: PlanePoint): void => {
  expect(x).toBeCloseTo(a, 12);
  expect(y).toBeCloseTo(b, 12);
};

test('what is taken hold of stays under the pointer, whichever handle it is', () => {
  const point: PlanePoint = [0.4, -0.7];
  const start = placed(from, point);
  const moved = dragged(from, 'move', start, [3, 3]);
  close(placed(moved, point), [3, 3]);
  const quarter: PlanePoint = [1 - (start[1] - 2), 2 + (start[0] - 1)];
  close(placed(dragged(from, 'turn', start, quarter), point), quarter);
  const twice: PlanePoint = [1 + 2 * (start[0] - 1), 2 + 2 * (start[1] - 2)];
  close(placed(dragged(from, 'scale', start, twice), point), twice);
});

test('a turn is told from −180 to 180 degrees', () => {
  expect(dragged({ ...from, turn: 170 }, 'turn', [2, 2], [1, 3]).turn).toBeCloseTo(-100, 9);
});

test('a scale never gets out of hand', () => {
  expect(dragged(from, 'scale', [2, 2], [1, 2]).scale).toBe(0.02);
  expect(dragged(from, 'scale', [1 + 1e-6, 2], [900, 2]).scale).toBe(50);
});
