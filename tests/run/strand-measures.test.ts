import { expect, test } from 'vitest';
import type { Strands } from '../../web/core/strands';
import { deepestInside, type Vec } from './strand-measures';

/** Two triangles a side, all facing outward, from −1 to 1; the lid is left out of an open one. */
function box({ open = false } = {}): [Vec, Vec, Vec][] {
  const triangles: [Vec, Vec, Vec][] = [];
  for (const axis of [0, 1, 2])
    for (const end of [-1, 1]) {
      if (open && axis === 1 && end === -1) continue;
      const at = (u: number, v: number): Vec => {
        const point = [0, 0, 0];
        point[axis] = end;
        point[(axis + 1) % 3] = u * end;
        point[(axis + 2) % 3] = v;
        return point as unknown as Vec;
      };
      triangles.push([at(-1, -1), at(1, -1), at(1, 1)], [at(-1, -1), at(1, 1), at(-1, 1)]);
    }
  return triangles;
}

const strand = (...points: Vec[]) =>
  ({
    offsets: Uint32Array.of(0, points.length),
    points: Float32Array.from(points.flat()),
    origin: [0, 0, 0],
  }) as unknown as Strands;

test('the deepest point of all is found, wherever it stands in its strand', () => {
  for (const open of [false, true]) {
    expect(deepestInside(strand([0, 1.1, 0], [0, 0.7, 0.1], [0, 1.2, 0]), box({ open }), 0.05)).toBeCloseTo(
      0.3,
    );
    expect(deepestInside(strand([0.5, 0.25, 0]), box({ open }), 0.05)).toBeCloseTo(0.5);
  }
});

test('points outside are not inside, near faces, edges and corners as well', () => {
  const outside: Vec[] = [
    [1.2, 0.3, 0.9],
    [1.1, 1.1, 0.2],
    [-1.2, 1.1, 1.3],
    [0, -3, 0],
  ];
  expect(deepestInside(strand(...outside), box(), 0.05)).toBe(0);
});

test('what is shallower than asked for is not told apart', () => {
  expect(deepestInside(strand([0, 0.97, 0]), box(), 0.05)).toBe(0);
});
