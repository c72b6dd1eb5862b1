import { beforeAll, describe, expect, test } from 'vitest';
import { IDENTITY } from '../../web/core/affine';
import type { Model } from '../../web/core/model';
import { vertexCount } from '../../web/core/model';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';
import { bowl, dome, tube } from '../kernel/tubes';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const upTo = (count: number) => Array.from({ length: count }, (_, i) => i);
const source: Model = { name: 'source', ...tube(24, 20, dome) };
const target: Model = { name: 'target', ...tube(24, 31, bowl, false) };
const boundary = {
  source: upTo(20),
  target: upTo(31),
  keys: [
    [0, 0],
    [10, 15],
  ],
};

async function run(step: object, models: Record<string, Model> = { source, target }) {
  const recipe = parseRecipe({
    lissom: 1,
    models: Object.fromEntries(Object.keys(models).map((name) => [name, { file: `${name}.ply` }])),
    steps: [{ id: 'm', type: 'merge', source: 'source', target: 'target', ...step }],
  });
  const runner = new Runner({ kernel, models: { load: async (name) => models[name]! } });
  return (await runner.run(recipe)).get('m') as StepResult<'merge'>;
}

/** How often each directed edge is run along. */
function runs({ faceOffsets, faceVertices }: Model): Map<string, number> {
  const found = new Map<string, number>();
  for (let f = 0; f + 1 < faceOffsets.length; f++)
    for (let k = faceOffsets[f]!; k < faceOffsets[f + 1]!; k++) {
      const next = k + 1 < faceOffsets[f + 1]! ? k + 1 : faceOffsets[f]!;
      const edge = `${faceVertices[k]} ${faceVertices[next]}`;
      found.set(edge, (found.get(edge) ?? 0) + 1);
    }
  return found;
}

function expectWatertight(model: Model) {
  const edges = runs(model);
  for (const [edge, times] of edges) {
    expect(times).toBe(1);
    expect(edges.has(edge.split(' ').reverse().join(' '))).toBe(true);
  }
}

/** Positions of the upper hemisphere and the whole, of an icosahedral-free ball: rows around y. */
const ball = (n: number, m: number, wave: number): Model => {
  const upper = tube(n, m, (s, t) => {
    const a = Math.PI * (0.02 + 0.98 * s);
    const r = 1 + wave * Math.sin(3 * t) * Math.sin(a) ** 2;
    return [r * Math.sin(a) * Math.cos(t), -r * Math.cos(a), r * Math.sin(a) * Math.sin(t)];
  });
  // Closed at the bottom too.
  const bottom = upper.positions.length / 3;
  const corners = [...upper.faceVertices];
  for (let j = 0; j < m; j++) corners.push(bottom, j, (j + 1) % m);
  return {
    name: 'ball',
    positions: Float64Array.from([...upper.positions, 0, -1, 0]),
    faceOffsets: Uint32Array.from({ length: corners.length / 3 + 1 }, (_, f) => 3 * f),
    faceVertices: Uint32Array.from(corners),
  };
};

const above = ({ positions }: Model, y: number) =>
  upTo(positions.length / 3).filter((v) => positions[3 * v + 1]! > y);

test('two open tubes become one watertight model, and the report says so', async () => {
  const { model, report } = await run({ boundaries: [boundary] });
  expectWatertight(model);
  expect(report).toMatchObject({ eulerCharacteristic: 2, sourceTurned: false });
  expect(report.seamVertices).toBeGreaterThanOrEqual(31);
  expect(report.vertices).toBe(vertexCount(model));
});

test('a pair of boundaries without keys has its key found', async () => {
  const { model, report } = await run({ boundaries: [{ ...boundary, keys: [] }] });
  expectWatertight(model);
  expect(report.warnings.map(({ code }) => code)).toContain('key-found');
});

test('colours and texture coordinates come along from both sides', async () => {
  const painted = (model: Model, color: readonly number[], u: number): Model => ({
    ...model,
    colors: Uint8Array.from(upTo(vertexCount(model)).flatMap(() => color)),
    uvs: Float64Array.from(upTo(vertexCount(model)).flatMap(() => [u, u])),
  });
  const models = {
    source: painted(source, [255, 0, 0, 255], 0.25),
    target: painted(target, [0, 0, 255, 255], 0.75),
  };
  const { model } = await run({ boundaries: [boundary] }, models);
  const { colors = new Uint8Array(), uvs = new Float64Array(), uvIndices = new Uint32Array() } = model;
  const seen = new Set(upTo(vertexCount(model)).map((v) => [...colors.subarray(4 * v, 4 * v + 4)].join(' ')));
  expect([...seen].sort()).toEqual(['0 0 255 255', '255 0 0 255']);
  expect(uvIndices.length).toBe(model.faceVertices.length);
  for (const at of uvIndices)
    expect(uvs[2 * at]).toSatisfy((u: number) => Math.min(Math.abs(u - 0.25), Math.abs(u - 0.75)) < 1e-9);
});

test('a transition between the two is closed as well', async () => {
  const transition = { sourceWidth: 0.4, targetWidth: 0.4 };
  const { model, report } = await run({ boundaries: [boundary], transition });
  expectWatertight(model);
  expect(report).toMatchObject({ eulerCharacteristic: 2 });
});

describe('a feature and two regions are enough', () => {
  const models = { source: ball(28, 40, 0.12), target: ball(24, 36, 0) };
  const optimalBoundary = {
    sourceRegion: above(models.source, 0),
    feature: above(models.source, 0.7),
    targetRegion: above(models.target, -0.2),
  };

  test('the boundary is found, its energy falls, and one closed model comes out', async () => {
    const { model, report } = await run({ optimalBoundary }, models);
    expectWatertight(model);
    const energy = report.energy!;
    expect(energy.length).toBeGreaterThan(1);
    for (const [k, value] of energy.entries()) if (k > 0) expect(value).toBeLessThanOrEqual(energy[k - 1]!);
    expect(report).toMatchObject({ eulerCharacteristic: 2 });
  });

  test('the placement found gives the same model when it is given', async () => {
    const found = await run({ optimalBoundary }, models);
    const placement = found.report.placement;
    const given = await run({ optimalBoundary: { ...optimalBoundary, placement } }, models);
    expect(given.model.positions).toEqual(found.model.positions);
  });

  test('boundaries beside it are refused', async () => {
    await expect(run({ optimalBoundary, boundaries: [boundary] }, models)).rejects.toMatchObject({
      code: 'two-boundaries',
    });
  });
});

test.each<[string, object]>([
  ['no-boundary', {}],
  ['loop-too-short', { boundaries: [{ ...boundary, source: [0, 1] }] }],
  ['loop-touches-itself', { boundaries: [{ ...boundary, source: [...upTo(20), 5] }] }],
  ['loop-not-connected', { boundaries: [{ ...boundary, source: [0, 7, 14] }] }],
  ['key-not-on-boundary', { boundaries: [{ ...boundary, keys: [[25, 0]] }] }],
  [
    'keys-out-of-order',
    {
      boundaries: [
        {
          ...boundary,
          keys: [
            [0, 0],
            [5, 8],
            [10, 22],
            [15, 15],
          ],
        },
      ],
    },
  ],
])('%s is said in words', async (code, step) => {
  await expect(run(step)).rejects.toMatchObject({ code, fault: 'input' });
});

test('joints of the models are left out, and told of', async () => {
  const count = vertexCount(target);
  const rig = {
    joints: [{ name: 'root', parent: -1, bind: IDENTITY }],
    influences: 4 as const,
    indices: new Uint16Array(4 * count),
    weights: Float32Array.from({ length: 4 * count }, (_, k) => (k % 4 === 0 ? 1 : 0)),
  };
  const { model, report } = await run({ boundaries: [boundary] }, { source, target: { ...target, rig } });
  expect(model.rig).toBeUndefined();
  expect(report.warnings.filter(({ code }) => code === 'rig-left-out')).toMatchObject([{ count: 1 }]);
  const without = await run({ boundaries: [boundary] });
  expect(without.report.warnings.map(({ code }) => code)).not.toContain('rig-left-out');
});
