// Transfer from the command line: what the report says, and what is said of pairs that cannot work.

import { describe, expect, test } from 'vitest';
import { IDENTITY } from '../../web/core/affine';
import type { Model } from '../../web/core/model';
import { writeModel } from '../../web/io/formats';
import { dome, tube } from '../kernel/tubes';
import { Shell } from './shell';

/** Two domes of different meshes; the second is larger. */
const SOURCE: Model = { name: 'source', ...tube(16, 20, dome) };
const TARGET: Model = { name: 'target', ...scaled(tube(24, 26, dome), 3) };

function scaled<T extends { readonly positions: Float64Array }>(shape: T, by: number): T {
  return { ...shape, positions: shape.positions.map((x) => by * x) };
}

const heights = ({ positions }: Model) => positions.filter((_, i) => i % 3 === 1);
/** The vertices in a share of a model's height, and its lowest and highest ones. */
function band(model: Model, from: number, to: number): number[] {
  const ys = heights(model);
  const [low, high] = [Math.min(...ys), Math.max(...ys)];
  return [...ys.keys()].filter((v) => {
    const share = (ys[v]! - low) / (high - low);
    return share >= from && share <= to;
  });
}

const moved = [...IDENTITY.slice(0, 12), 0.4, 0.3, 0, 1];
const POSE = {
  id: 'pose',
  type: 'deform',
  model: 's',
  handles: [
    { kind: 'region', vertices: band(SOURCE, 0, 0.15), matrix: IDENTITY },
    { kind: 'region', vertices: band(SOURCE, 0.85, 1), matrix: moved },
  ],
};
const HANDLES = [band(TARGET, 0, 0.15), band(TARGET, 0.85, 1)];

async function transfer(fields: object, command = 'run') {
  const shell = new Shell();
  shell.write('s.ply', writeModel(SOURCE, 'ply'));
  shell.write('t.ply', writeModel(TARGET, 'ply'));
  const recipe = shell.write('r.json', {
    lissom: 1,
    models: { s: { file: 's.ply' }, t: { file: 't.ply' } },
    steps: [POSE, { id: 'give', type: 'transfer', model: 't', like: 'pose', handles: HANDLES, ...fields }],
    outputs: [{ step: 'give', file: 'o.ply' }],
  });
  const out = ['--out', shell.path('out'), '--report', shell.path('report.json')];
  return { shell, ...(await shell.lissom([command, recipe, ...(command === 'run' ? out : [])])) };
}

test('the pose is given, and the report says what it took', async () => {
  const { shell, status, stderr } = await transfer({});
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  const model = shell.model('out/o.ply');
  expect(model.faceVertices).toEqual(TARGET.faceVertices);
  expect(model.positions.every(Number.isFinite)).toBe(true);
  // The top has moved up and to the side, by the source's share of its own size.
  const top = HANDLES[1]![0]!;
  expect(model.positions[3 * top]! - TARGET.positions[3 * top]!).toBeGreaterThan(0.3);
  const { steps } = JSON.parse(shell.read('report.json'));
  expect(steps.map(({ id, type }: { id: string; type: string }) => [id, type])).toEqual([
    ['pose', 'deform'],
    ['give', 'transfer'],
  ]);
  expect(steps[1]).toMatchObject({
    vertices: TARGET.positions.length / 3,
    unknowns: expect.any(Number),
    iterations: expect.any(Number),
    seconds: {
      fields: expect.any(Number),
      reduce: expect.any(Number),
      perIteration: expect.any(Number),
      solve: expect.any(Number),
    },
  });
  // What is said is what is said of the file.
  expect(steps[1].warnings.map(({ code }: { code: string }) => code)).toEqual(['open-boundary']);
});

test('half the strength gives less', async () => {
  const top = HANDLES[1]![0]!;
  const x = async (strength: number) =>
    (await transfer({ strength })).shell.model('out/o.ply').positions[3 * top]!;
  const [none, half, whole] = [await x(0), await x(0.5), await x(1)];
  expect(none).toBeCloseTo(TARGET.positions[3 * top]!, 9);
  expect(half).toBeGreaterThan(none);
  expect(whole).toBeGreaterThan(half);
});

describe.each(['check', 'run'])('%s refuses', (command) => {
  test.each<[string, object]>([
    ['handle-count', { handles: [HANDLES[0]] }],
    ['not-a-pose', { like: 's' }],
    ['index-out-of-range', { handles: [[0], [TARGET.positions.length / 3]] }],
    ['handle-overlap', { handles: ['all', HANDLES[1]] }],
    ['recipe-invalid', { strength: 3 }],
  ])('%s', async (code, fields) => {
    const { shell, status, stderr } = await transfer(fields, command);
    expect({ status, stderr }).toEqual({
      status: 2,
      stderr: expect.stringMatching(new RegExp(`^error: ${code}: steps\\[1\\][^\n]{30,}\\.\n$`)),
    });
    expect(shell.files('out')).toEqual([]);
  });
});
