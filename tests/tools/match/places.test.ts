import { describe, expect, test } from 'vitest';
import { gap } from '../../../web/tools/geometry';
import {
  nearestOnTriangle,
  nearestSpot,
  pointOf,
  type Surface,
  spotAt,
} from '../../../web/tools/match/places';
import type { Vec3 } from '../../../web/view/types';
import { pear } from '../../kernel/balls';

/** A square of one face, drawn as two triangles, and one beside it. */
const SHEET: Surface = {
  model: {
    name: 'sheet',
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0),
    faceOffsets: Uint32Array.of(0, 4, 8),
    faceVertices: Uint32Array.of(0, 1, 2, 3, 1, 4, 5, 2),
  },
  opened: {
    triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2),
    faceOfTriangle: Uint32Array.of(0, 0, 1, 1),
  },
};

const hit = (triangle: number, point: Vec3) => ({
  triangle,
  point,
  vertex: 0,
  normal: [0, 0, 1] as Vec3,
  distance: 1,
});

describe('a place under the pointer', () => {
  test('is told by weights of the face’s corners, which are 1 together', () => {
    const { place, point } = spotAt(SHEET, hit(1, [0.2, 0.7, 0]));
    expect(place).toEqual({
      face: 0,
      at: [expect.closeTo(0.3), 0, expect.closeTo(0.2), expect.closeTo(0.5)],
    });
    expect(gap(point, [0.2, 0.7, 0])).toBeLessThan(1e-4);
    expect(pointOf(SHEET, place)).toEqual(point);
  });

  test('rounding never makes them more or less than 1', () => {
    for (let i = 0; i < 300; i++) {
      const [x, y] = [((i * 37) % 101) / 101, ((i * 53) % 97) / 97];
      const { place } = spotAt(SHEET, hit(x > y ? 0 : 1, [x, y, 0]));
      const { at } = place as { at: number[] };
      expect(Math.abs(at.reduce((sum, each) => sum + each, 0) - 1)).toBeLessThan(1e-9);
      for (const weight of at) expect(weight).toBeGreaterThanOrEqual(0);
    }
  });

  test('that a model does not have is none', () => {
    expect(pointOf(SHEET, 99)).toBeNull();
    expect(pointOf(SHEET, { face: 9, at: [1, 0, 0] })).toBeNull();
    expect(pointOf(SHEET, { face: 0, at: [1, 0, 0] })).toBeNull();
  });
});

describe('the nearest place', () => {
  test('of a point beside, above or at a corner of a triangle', () => {
    const [a, b, c]: Vec3[] = [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ];
    const near = (p: Vec3) => nearestOnTriangle(a!, b!, c!, p);
    expect(gap(near([0.2, 0.2, 5]), [0.2, 0.2, 0])).toBeLessThan(1e-12);
    expect(gap(near([-1, -1, 3]), [0, 0, 0])).toBeLessThan(1e-12);
    expect(gap(near([3, -0.1, 0]), [1, 0, 0])).toBeLessThan(1e-12);
    expect(gap(near([0.5, -2, 1]), [0.5, 0, 0])).toBeLessThan(1e-12);
    expect(gap(near([1, 1, 0]), [0.5, 0.5, 0])).toBeLessThan(1e-12);
    expect(gap(near([-0.1, 4, 0]), [0, 1, 0])).toBeLessThan(1e-12);
  });

  test('is no further than any vertex, and on the surface', () => {
    const shape = pear();
    const model = { name: 'pear', ...shape };
    const faces = shape.faceOffsets.length - 1;
    const surface: Surface = {
      model,
      opened: {
        triangles: shape.faceVertices,
        faceOfTriangle: Uint32Array.from({ length: faces }, (_, face) => face),
      },
    };
    for (const to of [
      [2, 0.3, 0.1],
      [0.1, -2, 0.4],
      [0.2, 0.1, 0.3],
    ] as Vec3[]) {
      const { spot, distance } = nearestSpot(surface, to)!;
      expect(Math.abs(gap(spot.point, to) - distance)).toBeLessThan(1e-3);
      for (let v = 0; v < model.positions.length / 3; v++) {
        const [x, y, z] = model.positions.subarray(3 * v, 3 * v + 3);
        expect(distance).toBeLessThanOrEqual(gap([x!, y!, z!], to) + 1e-12);
      }
    }
  });
});
