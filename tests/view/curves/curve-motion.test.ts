import { expect, test } from 'vitest';
import { product, type Quaternion, unitQuaternion } from '../../../web/core/quaternion';
import { TEXELS } from '../../../web/view/curves/curve-glsl';
import { CurveMotion, placesInView, tableInView } from '../../../web/view/curves/curve-motion';
import { ViewSpace } from '../../../web/view/view-space';
import { posed } from './curve-reference';

const ROWS = 256;
const BOX = Float64Array.of(10, 20, 30, 14, 23, 42);
const SPACES = (['y', 'z'] as const).map(
  (upAxis) => [upAxis, ViewSpace.around({ positions: BOX, upAxis })] as const,
);

/** Two curves through the box that turn, shift and widen from row to row, and five vertices that go by them. */
const centre = [11, 21, 37] as const;
const rows = Array.from({ length: 2 * ROWS }, (_, i) => i / ROWS);
const texels = Float32Array.from(
  rows.flatMap((at) => {
    const real = unitQuaternion([Math.sin(at), 0.3 * at, -0.2, 1.5]);
    const shift: Quaternion = [2 * at, 1, -at, 0];
    const dual = product(shift, real).map((x) => x / 2);
    return [...real, ...dual, 1 + at, 0.1, 0, 0.5, 0.2 * at, 1.2, 0.3, -1, 0, -0.1, 0.8, at];
  }),
);
const slopes = Float64Array.from(
  rows.flatMap((at) => [at, -at, 5 * at - 3, 20, 0.3, 10 * at, 0.02, 0.05 * at, -0.01]),
);
const curves = Uint16Array.of(0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0);
const places = Float32Array.of(
  17.3,
  0,
  0,
  0,
  255,
  0,
  0,
  0,
  200,
  30.7,
  0,
  0,
  100.5,
  99,
  1.25,
  254.5,
  0,
  0,
  0,
  0,
);
const weights = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 0.25, 0.75, 0, 0, 0.3, 0.2, 0.1, 0.05, 0, 0, 0, 0);
const attributes = { curves, rows: places, weights, centre, slopes, frames: new Float64Array() };
const rest = Float64Array.of(10, 20, 30, 14, 23, 42, 12, 22, 35, 13, 20.5, 41, 11, 22, 33);
const normals = Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6, 0.8, 0, 0, -0.6, 0.8);

/** A packed table less the maps of both, as the kernel writes it. */
const asGiven = (packed: Float32Array) => packed.filter((_, k) => k % (4 * TEXELS) < 20);

test.each(SPACES)('a table moves drawn places and normals as it moves the model’s, %s up', (_, space) => {
  const model = posed(attributes, texels, rest, normals);
  const drawn = new Float32Array(rest.length);
  space.place(rest, drawn);
  const upright = (directions: Float64Array) =>
    directions.map((x, k) => {
      if (!space.zUp || k % 3 === 0) return x;
      return k % 3 === 1 ? directions[k + 1]! : -directions[k - 1]!;
    });
  const packed = tableInView(texels, attributes, space);
  const { first, texels: others } = placesInView(attributes, rest, space, 4 * 3 * 5);
  const own = { ...attributes, centre: [0, 0, 0] as const };
  const seen = posed(own, asGiven(packed), drawn, upright(normals), (v, slot) =>
    slot === 0 ? first.subarray(4 * v, 4 * v + 3) : others.subarray(4 * (3 * v + slot - 1)),
  );
  const wanted = new Float32Array(rest.length);
  space.place(model.positions, wanted);
  expect([...seen.positions]).toEqual([...wanted].map((x) => expect.closeTo(x, 5)));
  expect([...seen.normals]).toEqual([...upright(model.normals)].map((x) => expect.closeTo(x, 4)));
  // What rests stays.
  expect([...seen.positions.subarray(12)]).toEqual([...drawn.subarray(12)].map((x) => expect.closeTo(x, 6)));
});

test.each(SPACES)('behind each row stands the map of its parts, %s up', (_, space) => {
  const packed = tableInView(texels, attributes, space);
  const still = { ...attributes, centre: [0, 0, 0] as const };
  const one = Float32Array.of(1, 0, 0, 0);
  for (const row of [0, 100, 254]) {
    const point = [0.3, -0.2, 0.5];
    const { positions } = posed(
      { ...still, curves: new Uint16Array(4), rows: Float32Array.of(row, 0, 0, 0), weights: one },
      asGiven(packed),
      point,
      [0, 0, 1],
    );
    const line = (k: number) => packed.subarray(4 * TEXELS * row + 20 + 4 * k, 4 * TEXELS * row + 24 + 4 * k);
    const moved = [0, 1, 2].map((k) => point.reduce((sum, x, j) => sum + line(k)[j]! * x, line(k)[3]!));
    expect(moved).toEqual([...positions].map((x) => expect.closeTo(x, 5)));
  }
});

test('a card with textures too small or too few lines is not used', () => {
  const motion = new CurveMotion(attributes, rest);
  expect(motion.vertexCount).toBe(5);
  const { table, inputs, textures } = motion.packed(SPACES[0]![1], 2048)!;
  expect(table).toEqual({ name: 'curveTable', width: 2048, height: 2 });
  expect(inputs.map(({ values }) => values.length)).toEqual([20, 20, 20]);
  expect(textures[0]).toMatchObject({ name: 'curvePlaces', width: 2048, height: 1 });
  expect(textures[0]!.texels).toHaveLength(4 * 2048);
  expect(motion.packed(SPACES[0]![1], 2047)).toBeNull();
});
