import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  compose,
  decompose,
  fromEuler,
  IDENTITY,
  invert,
  type Mat4,
  multiply,
  rotationOf,
  toEuler,
  transform,
} from '../../web/tools/geometry';
import { rigidFit } from '../../web/tools/rigid-fit';

const close = (a: readonly number[], b: readonly number[], eps = 1e-9) =>
  expect(Math.max(...a.map((x, i) => Math.abs(x - b[i]!)))).toBeLessThan(eps);

const coordinate = fc.double({ min: -10, max: 10, noNaN: true });
const vec = fc.tuple(coordinate, coordinate, coordinate);
const angles = fc.tuple(
  fc.double({ min: -179, max: 179, noNaN: true }),
  fc.double({ min: -89, max: 89, noNaN: true }),
  fc.double({ min: -179, max: 179, noNaN: true }),
);
const factor = fc.double({ min: 0.1, max: 5, noNaN: true });
const scales = fc.tuple(factor, factor, factor);

describe('small affine maps', () => {
  test('parts put together and taken apart are the same parts', () => {
    fc.assert(
      fc.property(vec, angles, scales, vec, (translation, rotation, scale, pivot) => {
        const parts = decompose(compose({ translation, rotation, scale }, pivot), pivot);
        close(parts.translation, translation);
        close(parts.rotation, rotation, 1e-6);
        close(parts.scale, scale);
      }),
    );
  });

  test('a map after its inverse is the identity', () => {
    fc.assert(
      fc.property(vec, angles, scales, (translation, rotation, scale) => {
        const m = compose({ translation, rotation, scale }, [1, 2, 3]);
        close(multiply(m, invert(m)!), IDENTITY);
      }),
    );
  });

  test('a map that flattens space has no inverse', () => {
    expect(invert([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1])).toBeUndefined();
  });

  test('90 degrees typed in turn exactly', () => {
    expect(transform(fromEuler([0, 0, 90]), [1, 0, 0])).toEqual([0, 1, 0]);
    expect(toEuler(fromEuler([90, 0, 0]))).toEqual([90, 0, 0]);
  });

  test('angles at the pole give the same rotation back', () => {
    const r = fromEuler([30, 90, 10]);
    close(fromEuler(toEuler(r)), r, 1e-7);
  });

  test('the rotation of a turned and scaled map is the turn', () => {
    const turn = fromEuler([20, 30, 40]);
    close(
      rotationOf(compose({ translation: [0, 0, 0], rotation: [20, 30, 40], scale: [2, 3, 4] }, [0, 0, 0])),
      turn,
    );
  });
});

describe('the rigid fit', () => {
  const points = Float64Array.from([0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 1, 1, 1]);
  const all = Uint32Array.from([0, 1, 2, 3, 4]);
  const moved = (m: Mat4) =>
    Float64Array.from(
      [0, 1, 2, 3, 4].flatMap((v) => transform(m, [...points.slice(3 * v, 3 * v + 3)] as never)),
    );

  test('finds the rigid map that was applied', () => {
    fc.assert(
      fc.property(vec, angles, (translation, rotation) => {
        const m = compose({ translation, rotation, scale: [1, 1, 1] }, [0, 0, 0]);
        close(rigidFit(points, moved(m), all), m, 1e-7);
      }),
    );
  });

  test('of half a turn is found too', () => {
    const m = fromEuler([0, 180, 0]);
    close(rigidFit(points, moved(m), all), m, 1e-7);
  });

  test('of points that have not moved is exactly the identity', () => {
    expect(rigidFit(points, points, all)).toBe(IDENTITY);
  });

  test('of one point only moves it', () => {
    const m = compose({ translation: [5, 0, 0], rotation: [0, 0, 90], scale: [1, 1, 1] }, [0, 0, 0]);
    expect(rigidFit(points, moved(m), Uint32Array.of(1))).toEqual([
      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 1, 0, 1,
    ]);
  });
});
