// Blends and garments from the command line: what is written, what the report says, what is refused.

import { describe, expect, test } from 'vitest';
import { writeModel } from '../../web/io/formats';
import { FRUIT, match } from '../run/fruit';
import { Shell } from './shell';

async function wear(step: object, command = 'run', before: readonly object[] = []) {
  const shell = new Shell();
  for (const [name, shape] of Object.entries(FRUIT))
    shell.write(`${name}.ply`, writeModel({ name, ...shape }, 'ply'));
  const recipe = shell.write('r.json', {
    lissom: 1,
    models: Object.fromEntries(Object.keys(FRUIT).map((name) => [name, { file: `${name}.ply` }])),
    steps: [match(), ...before, { id: 'x', match: 'm', ...step }],
    outputs: [{ step: 'x', file: 'x.ply' }],
  });
  const out = ['--out', shell.path('out'), '--report', shell.path('report.json')];
  return { shell, ...(await shell.lissom([command, recipe, ...(command === 'run' ? out : [])])) };
}

test('a blend is written, with its weights and measures in the report', async () => {
  const measures = [{ kind: 'height', value: 2.3 }];
  const { shell, status, stderr } = await wear({ type: 'blend', weights: { pear: 1 }, measures });
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  const heights = shell.model('out/x.ply').positions.filter((_, at) => at % 3 === 1);
  expect(Math.max(...heights) - Math.min(...heights)).toBeCloseTo(2.3, 3);
  const step = JSON.parse(shell.read('report.json')).steps[1];
  expect(step).toMatchObject({
    id: 'x',
    type: 'blend',
    measures: [{ kind: 'height', value: 2.3 }],
    weights: { pear: expect.any(Number), plum: expect.any(Number) },
    seconds: { factor: expect.any(Number), blend: expect.any(Number), measure: expect.any(Number) },
  });
});

test('a garment is written, and nothing of it is inside', async () => {
  const { shell, status, stderr } = await wear({ type: 'dress', garment: 'belt', from: 'pear', to: 'plum' });
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  expect(shell.model('out/x.ply').faceVertices).toEqual(FRUIT.belt.faceVertices);
  const step = JSON.parse(shell.read('report.json')).steps[1];
  expect(step).toMatchObject({
    type: 'dress',
    inside: 0,
    insideBefore: { vertices: expect.any(Number), faceCentres: expect.any(Number) },
    vertices: FRUIT.belt.positions.length / 3,
  });
});

/** The upper end of a shape moved to the side. */
const POSE = {
  id: 'pose',
  type: 'deform',
  model: 'pear',
  handles: [-1, 1].map((side) => ({
    kind: 'region',
    vertices: [...FRUIT.pear.positions.keys()]
      .filter((at) => at % 3 === 1 && side * FRUIT.pear.positions[at]! > 0.6)
      .map((at) => (at - 1) / 3),
    matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, side > 0 ? 0.8 : 0, 0, 0, 1],
  })),
};

test('a pose goes through a match, and nothing is paired', async () => {
  const { shell, status, stderr } = await wear(
    { type: 'transfer', model: 'plum', like: 'pose', match: undefined, through: 'm' },
    'run',
    [POSE],
  );
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  const posed = shell.model('out/x.ply');
  expect(posed.faceVertices).toEqual(FRUIT.plum.faceVertices);
  const rightmost = ({ positions }: { positions: Float64Array }) =>
    positions.reduce((most, x, at) => (at % 3 === 0 ? Math.max(most, x) : most), 0);
  expect(rightmost(posed)).toBeGreaterThan(rightmost(FRUIT.plum));
  const step = JSON.parse(shell.read('report.json')).steps[2];
  expect(step).toMatchObject({
    type: 'transfer',
    unknowns: expect.any(Number),
    iterations: 3,
    seconds: { prepare: expect.any(Number), solve: expect.any(Number) },
  });
});

describe.each(['check', 'run'])('%s refuses', (command) => {
  test.each<[string, object]>([
    ['a weight of nobody', { type: 'blend', weights: { apple: 1 } }],
    [
      'a pose to a model that was not matched',
      { type: 'transfer', model: 'belt', like: 'pear', match: undefined, through: 'm' },
    ],
    ['a body that was not matched', { type: 'dress', garment: 'belt', from: 'pear', to: 'belt' }],
  ])('%s', async (_, step) => {
    const { shell, status, stderr } = await wear(step, command);
    expect(status).toBe(2);
    expect(stderr).toMatch(/^error: recipe-invalid: steps\[1\].+it has "pear", "plum"\.\n$/);
    expect(shell.files('out')).toEqual([]);
  });
});
