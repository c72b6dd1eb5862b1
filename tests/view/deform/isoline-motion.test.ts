import { expect, test } from 'vitest';
import { IsolineMotion, offsetsInView, packFields } from '../../../web/view/deform/isoline-motion';
import type { IsolineSurface } from '../../../web/view/deform/types';
import type { Vec3 } from '../../../web/view/types';
import { ViewSpace } from '../../../web/view/view-space';

const BOX = Float64Array.of(10, 20, 30, 14, 23, 42);
const SPACES = (['y', 'z'] as const).map(
  (upAxis) => [upAxis, ViewSpace.around({ positions: BOX, upAxis })] as const,
);

const OFFSET = Float64Array.of(0.1, -0.4, 0.2, 3, 0.7, 0.3, -0.9, -2, 0.5, -0.6, 0.8, 1);

function moved(offset: ArrayLike<number>, [x, y, z]: readonly [number, number, number]): Vec3 {
  const row = (k: number) =>
    offset[4 * k]! * x + offset[4 * k + 1]! * y + offset[4 * k + 2]! * z + offset[4 * k + 3]!;
  return [x + row(0), y + row(1), z + row(2)];
}

test.each(SPACES)('an offset moves drawn places as it moves the model’s, %s up', (_, space) => {
  const drawn = offsetsInView(OFFSET, space);
  for (const point of [
    [10, 20, 30],
    [12, 21, 35],
    [-3, 50, 8],
  ] as const) {
    const there = space.toView(moved(OFFSET, point)).toArray();
    const here = moved(drawn, space.toView(point).toArray());
    expect(here).toEqual(there.map((x) => expect.closeTo(x, 5)));
  }
});

const surface = (parts: Partial<IsolineSurface> = {}): IsolineSurface => ({
  sets: 2,
  single: false,
  basis: 'quadratic',
  controls: 10,
  fields: Float32Array.of(0, 1, 0.25, 0.75, 0.5, 0.5),
  gradients: Float32Array.of(0, 0, 0, 0, 0, 0, 1, 2, -4, 0, 0, 0, 0, 0, 0, 0, 0, 4),
  ...parts,
});

test('values are kept to a 65535th, gradients to a 32767th of the steepest', () => {
  const space = SPACES[0]![1];
  const { texels, width, height, steepest } = packFields(surface(), space, 4096)!;
  expect([width, height]).toEqual([6, 1]);
  expect(steepest).toBeCloseTo(4 / space.scale, 12);
  const value = (i: number) => texels[4 * i + 3]! / 65535;
  expect([0, 1, 2, 3].map(value)).toEqual([0, 1, 0.25, 0.75].map((x) => expect.closeTo(x, 4)));
  const gradient = [0, 1, 2].map((k) => ((texels[8 + k]! - 32767) / 32767) * 4);
  expect(gradient).toEqual([1, 2, -4].map((x) => expect.closeTo(x, 3)));
});

test('gradients turn upright with the model', () => {
  const { texels } = packFields(surface(), SPACES[1]![1], 4096)!;
  const gradient = [0, 1, 2].map((k) => ((texels[8 + k]! - 32767) / 32767) * 4);
  expect(gradient).toEqual([1, -4, -2].map((x) => expect.closeTo(x, 3)));
});

test('no gradient is taken for the mark of a vertex that stays', () => {
  const steep = Float32Array.from({ length: 18 }, (_, i) => (i % 2 ? 9 : -9));
  const { texels } = packFields(
    surface({ gradients: steep, still: Uint8Array.of(0, 1, 0) }),
    SPACES[0]![1],
    4096,
  )!;
  expect([0, 1, 2, 3, 4, 5].map((i) => texels[4 * i] === 65535)).toEqual([
    false,
    false,
    true,
    true,
    false,
    false,
  ]);
});

test('what is too much for one texture is not packed', () => {
  const { width, height } = packFields(surface(), SPACES[0]![1], 3)!;
  expect([width, height]).toEqual([3, 2]);
  expect(packFields(surface(), SPACES[0]![1], 2)).toBeNull();
});

test('the shader is written for its surface, and more controls than a texture has lines are too many', () => {
  const motion = new IsolineMotion(surface());
  expect(motion.vertexCount).toBe(3);
  const { glsl, table } = motion.packed(SPACES[0]![1], 4096)!;
  expect(glsl).toMatch(/const int SETS = 2;\s+const int CONTROLS = 10;/);
  expect(table).toEqual({ name: 'isolineOffsets', width: 3, height: 20 });
  expect(motion.packed(SPACES[0]![1], 19)).toBeNull();
});
