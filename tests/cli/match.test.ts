// Matches from the command line: skins in one connectivity, the report, and what is said of matches that cannot be.

import { expect, test } from 'vitest';
import { writeModel } from '../../web/io/formats';
import { FRUIT, marks, match } from '../run/fruit';
import { Shell } from './shell';

async function matched(
  fields: object = {},
  outputs: object[] = [
    { step: 'm/pear', file: 'pear.ply' },
    { step: 'm/plum', file: 'plum.obj' },
  ],
) {
  const shell = new Shell();
  for (const name of ['pear', 'plum', 'fig'] as const)
    shell.write(`${name}.ply`, writeModel({ name, ...FRUIT[name] }, 'ply'));
  const recipe = shell.write('r.json', {
    lissom: 1,
    models: { pear: { file: 'pear.ply' }, plum: { file: 'plum.ply' }, fig: { file: 'fig.ply' } },
    steps: [match(fields)],
    outputs,
  });
  const out = ['--out', shell.path('out'), '--report', shell.path('report.json')];
  return { shell, ...(await shell.lissom(['run', recipe, ...out])) };
}

test('skins of one connectivity are written, and the report says what they are worth', async () => {
  const { shell, status, stderr } = await matched();
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  const [first, second] = [shell.model('out/pear.ply'), shell.model('out/plum.obj')];
  expect(second.faceVertices).toEqual(first.faceVertices);
  const [step] = JSON.parse(shell.read('report.json')).steps;
  expect(step).toMatchObject({
    id: 'm',
    type: 'match',
    vertices: first.positions.length / 3,
    models: { pear: { faces: first.faceOffsets.length - 1 } },
    flipped: { pear: 0, plum: 0 },
    selfIntersections: { pear: 0, plum: 0 },
  });
  expect(step.distance.plum.mean).toBeLessThan(0.004);
});

test('three models pair by pair: the report has all of them, and the sharp edges that are lost', async () => {
  const three = {
    models: ['pear', 'plum', 'fig'],
    markers: marks().map((pair, at) => [...pair, FRUIT.fig.ends[at]!]),
    // A chain along edges of the third model.
    sharp: [[], [], [FRUIT.fig.faceVertices.slice(0, 2)].map((row) => [...row])],
    together: false,
  };
  const { shell, status, stderr } = await matched(three, [{ step: 'm/fig', file: 'fig.ply' }]);
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  const [step] = JSON.parse(shell.read('report.json')).steps;
  expect(Object.keys(step.distance)).toEqual(['pear', 'plum', 'fig']);
  expect(step.warnings).toContainEqual(
    expect.objectContaining({ code: 'sharp-lost', model: 'fig', count: 1 }),
  );
  expect(shell.model('out/fig.ply').positions.length / 3).toBe(step.vertices);
});

test('one skin is written with the others as morph targets', async () => {
  const { shell, status, stderr } = await matched({}, [{ step: 'm/plum', file: 'all.gltf', morphs: true }]);
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  const { meshes } = JSON.parse(shell.read('out/all.gltf'));
  expect(meshes[0]).toMatchObject({ name: 'plum', weights: [0], extras: { targetNames: ['pear'] } });
  expect(meshes[0].primitives[0].targets).toHaveLength(1);
});

test('markers that are not set everywhere are left out, and counted', async () => {
  const { shell, status } = await matched({ markers: [...marks(), [3, null], [null, 5]] });
  expect(status).toBe(0);
  const [step] = JSON.parse(shell.read('report.json')).steps;
  expect(step.warnings).toContainEqual({
    code: 'marker-incomplete',
    count: 2,
    examples: [6, 7],
    repaired: false,
  });
});

test.each<[string, object, object[]?]>([
  ['marker-count', { markers: marks(2) }],
  ['index-out-of-range', { markers: [...marks(5), [99999, 0]] }],
  ['recipe-invalid', { models: ['pear', 'apple'] }],
  ['recipe-invalid', {}, [{ step: 'm', file: 'both.ply' }]],
  ['recipe-invalid', {}, [{ step: 'm/pear', file: 'all.ply', morphs: true }]],
  ['marker-count', { markers: [marks()[0], [1, null], [2, null]] }],
])('%s', async (code, fields, outputs) => {
  const { shell, status, stderr } = await matched(fields, outputs);
  expect(status).toBe(2);
  expect(stderr).toMatch(new RegExp(`^error: ${code}: .+\n$`));
  expect(shell.files('out')).toEqual([]);
});
