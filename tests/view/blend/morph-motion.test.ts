import { expect, test } from 'vitest';
import { MorphMotion, packShapes } from '../../../web/view/blend/morph-motion';
import type { Vec3 } from '../../../web/view/types';
import { ViewSpace } from '../../../web/view/view-space';

const TRIANGLES = Uint32Array.of(0, 1, 2, 0, 3, 1);
const SHAPES = [
  Float64Array.of(10, 20, 30, 11, 20, 30, 10, 21, 30, 10, 20, 31),
  Float64Array.of(12, 20, 30, 14, 20, 31, 12, 23, 30, 12, 19, 33),
];
const BESIDE = Float64Array.of(0, 0, 0, 0.5, -1, 2, 0, 0, 0, 0, 0, 0);
const SPACES = (['y', 'z'] as const).map(
  (upAxis) => [upAxis, ViewSpace.around({ positions: SHAPES[0]!, upAxis })] as const,
);

/** What the shader makes of a vertex, in the space that is drawn. */
function drawnAt(motion: MorphMotion, space: ViewSpace, weights: Float64Array, vertex: number): Vec3 {
  const { textures, tableOf } = motion.packed(space, 4096)!;
  const { texels } = textures[0]!;
  const table = tableOf(weights);
  const shapes = table.length / 4;
  const origin = space.toView([0, 0, 0]).toArray();
  const sum = [...origin] as [number, number, number];
  for (let shape = 0; shape < shapes; shape++)
    for (let k = 0; k < 3; k++) {
      const place = texels[8 * (vertex * shapes + shape) + k]!;
      sum[k] = sum[k]! + table[4 * shape]! * (place - table[4 * shape + 1]! * origin[k]!);
    }
  return sum;
}

function expected(weights: Float64Array, vertex: number, beside?: Float64Array): Vec3 {
  const at = (k: number) =>
    weights.reduce((sum, w, shape) => sum + w * SHAPES[shape]![3 * vertex + k]!, 0) +
    (beside?.[3 * vertex + k] ?? 0);
  return [at(0), at(1), at(2)];
}

test.each(SPACES)('a sum of shapes is drawn where the sum is, whole or not, %s up', (_, space) => {
  const motion = new MorphMotion({ positions: SHAPES, triangles: TRIANGLES });
  expect(motion.exact).toBe(true);
  for (const weights of [Float64Array.of(0.3, 0.7), Float64Array.of(1, 1), Float64Array.of(-0.5, 0.2)])
    for (let v = 0; v < motion.vertexCount; v++) {
      const there = space.toView(expected(weights, v)).toArray();
      expect(drawnAt(motion, space, weights, v)).toEqual(there.map((x) => expect.closeTo(x, 4)));
    }
});

test.each(SPACES)('what comes beside is added as it is, %s up', (_, space) => {
  const motion = new MorphMotion({ positions: SHAPES, triangles: TRIANGLES, beside: BESIDE });
  expect(motion.exact).toBe(false);
  const weights = Float64Array.of(0.25, 0.75);
  for (let v = 0; v < motion.vertexCount; v++) {
    const there = space.toView(expected(weights, v, BESIDE)).toArray();
    expect(drawnAt(motion, space, weights, v)).toEqual(there.map((x) => expect.closeTo(x, 4)));
  }
});

test('what does not fit the card is refused', () => {
  const shapes = { positions: SHAPES, triangles: TRIANGLES };
  expect(packShapes(shapes, SPACES[0]![1], 3)).toBeNull();
  expect(packShapes(shapes, SPACES[0]![1], 4)).toMatchObject({ width: 4, height: 4 });
});
