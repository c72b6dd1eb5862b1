import { expect, test } from 'vitest';
import { isHidden } from '../../web/tools/sight';
import type { Vec3 } from '../../web/view/types';

/** Seen along −z from ten units away; a wall stands at z = 1 where x is negative. */
const view = {
  camera: { position: [0, 0, 10] as Vec3, target: [0, 0, 0] as Vec3, orthographic: false },
  project: ([x, y, z]: Vec3) => ({ x, y, behind: z > 10 }),
  pick: (x: number, y: number) =>
    x < 0
      ? { point: [x, y, 1] as Vec3, normal: [0, 0, 1] as Vec3, triangle: 0, vertex: 0, distance: 9 }
      : null,
};

test('a point is hidden behind a surface and behind the eye, in front of one or on one it is not', () => {
  expect(isHidden(view, [-0.1, 0, 0])).toBe(true);
  expect(isHidden(view, [0.1, 0, 0])).toBe(false);
  expect(isHidden(view, [-0.1, 0, 3])).toBe(false);
  expect(isHidden(view, [-0.1, 0, 0.99])).toBe(false);
  expect(isHidden(view, [0.1, 0, 11])).toBe(true);
});
