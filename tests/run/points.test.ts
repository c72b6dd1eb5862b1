// Points without faces, on the real kernel: posed and bent like a surface, and points again when they leave.

import { beforeAll, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { readModel, writeModel } from '../../web/io/index';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { Runner } from '../../web/run/evaluate';
import { dome, tube } from '../kernel/tubes';
import { recipeOfStep } from './curves-recipe';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const SHAPE = tube(60, 32, (s, t) => dome(s, t).map((x, k) => (k === 1 ? x : 0.3 * x)) as never);
/** From y = 0 to 2, 0.6 wide, without its faces. */
const CLOUD: Model = {
  name: 'cloud',
  positions: SHAPE.positions,
  faceOffsets: Uint32Array.of(0),
  faceVertices: new Uint32Array(),
};

const runner = () => new Runner({ kernel, models: { load: async () => CLOUD } });
const run = async (step: object): Promise<Model> => (await runner().run(recipeOfStep(step))).get('s')!.model;

const CURVE = { id: 'limb', kind: 'skeleton', rest: [0.1, 0.7, 1.3, 1.9].map((y) => [0, y, 0]) };
const away = (model: Model, v: number) =>
  Math.hypot(...[0, 1, 2].map((k) => model.positions[3 * v + k]! - CLOUD.positions[3 * v + k]!));

test('a curve poses points, and at rest leaves them where they are', async () => {
  const rest = await run({ curves: [CURVE] });
  expect(
    Math.max(...Array.from({ length: rest.positions.length / 3 }, (_, v) => away(rest, v))),
  ).toBeLessThan(1e-12);
  const posed = [...CURVE.rest.slice(0, 2), [0.25, 1.25, 0], [0.7, 1.6, 0]];
  const bent = await run({ curves: [{ ...CURVE, posed, anchor: 'start' }] });
  expect(away(bent, 0)).toBeLessThan(1e-9);
  expect(away(bent, 58 * 32)).toBeGreaterThan(0.5);
  expect(bent.positions.every(Number.isFinite)).toBe(true);
  expect(bent.faceVertices).toHaveLength(0);
});

test('handles bend points', async () => {
  const rows = (from: number, to: number) =>
    Array.from({ length: 32 * (to - from) }, (_, i) => 32 * from + i);
  const moved = await run({
    type: 'deform',
    roi: 'all',
    handles: [
      {
        name: 'foot',
        kind: 'region',
        vertices: rows(0, 3),
        matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
      },
      {
        name: 'tip',
        kind: 'region',
        vertices: rows(56, 60),
        matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.4, 0, 0, 1],
      },
    ],
  });
  expect(away(moved, 57 * 32)).toBeCloseTo(0.4, 6);
  const middle = away(moved, 30 * 32);
  expect(middle).toBeGreaterThan(0.05);
  expect(middle).toBeLessThan(0.4);
});

test('a stroke over points finds the middle of the limb', async () => {
  const ys = Array.from({ length: 40 }, (_, i) => 0.2 + (1.5 * i) / 39);
  const { points } = await runner().ask(recipeOfStep({ curves: [] }), 's', 'sketchedCurve', {
    pixels: Float64Array.from(ys.flatMap((y) => [400, 500 - 200 * y])),
    origins: Float64Array.from(ys.flatMap((y) => [0.02, y, 5])),
    directions: Float64Array.from(ys.flatMap(() => [0, 0, -1])),
    options: { kind: 'skeleton' },
  });
  for (let i = 0; i < points.length; i += 3)
    expect(Math.hypot(points[i]!, points[i + 2]!)).toBeLessThan(0.05);
});

test.each(['obj', 'ply'] as const)('they leave as points in %s', (format) => {
  const { model, notes } = readModel(writeModel(CLOUD, format), `cloud.${format}`);
  expect(notes.map(({ code }) => code)).toEqual(['no-faces']);
  expect(model.positions).toHaveLength(CLOUD.positions.length);
  expect(model.faceVertices).toHaveLength(0);
});
