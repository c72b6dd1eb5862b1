// Curves from the command line: what the report says, and what is said of curves that cannot be.

import { describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { writeModel } from '../../web/io/formats';
import { dome, tube } from '../kernel/tubes';
import { Shell } from './shell';

const MODEL: Model = { name: 'm', ...tube(24, 20, dome) };
const AXIS = [0, 1, 2, 3, 4].map((k) => [0, 0.2 + 0.4 * k, 0]);
const BENT = AXIS.map(([x, y, z]) => [x! + 0.3 * (y! - 0.2) ** 2, y, z]);
const curve = (more: object = {}) => ({ id: 'c', kind: 'skeleton', rest: AXIS, ...more });

async function curves(fields: object, command = 'run', outputs: object[] = [{ step: 's', file: 'o.ply' }]) {
  const shell = new Shell();
  shell.write('m.ply', writeModel(MODEL, 'ply'));
  const recipe = shell.write('r.json', {
    lissom: 1,
    models: { m: { file: 'm.ply' } },
    steps: [{ id: 's', type: 'curves', model: 'm', curves: [curve()], ...fields }],
    outputs,
  });
  const out = ['--out', shell.path('out'), '--report', shell.path('report.json')];
  return { shell, ...(await shell.lissom([command, recipe, ...(command === 'run' ? out : [])])) };
}

test('a curve bends the model, and the report says what it took', async () => {
  const { shell, status, stderr } = await curves({
    curves: [curve({ posed: BENT, twist: [0, 10, 20, 30, 40], anchor: 'start' })],
  });
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  const model = shell.model('out/o.ply');
  expect(model.faceVertices).toEqual(MODEL.faceVertices);
  const top = MODEL.positions.length / 3 - 1;
  expect(model.positions[3 * top]! - MODEL.positions[3 * top]!).toBeGreaterThan(0.5);
  const [step] = JSON.parse(shell.read('report.json')).steps;
  expect(step).toMatchObject({
    id: 's',
    type: 'curves',
    vertices: MODEL.positions.length / 3,
    curves: 1,
    selfIntersections: { before: 0, after: 0 },
    seconds: { regions: expect.any(Number), encode: expect.any(Number), pose: expect.any(Number) },
  });
});

test('at rest the file is the model', async () => {
  const { shell, status } = await curves({});
  expect(status).toBe(0);
  for (const [k, x] of shell.model('out/o.ply').positions.entries())
    expect(x).toBeCloseTo(MODEL.positions[k]!, 12);
});

test('poses that are kept change nothing of what is left', async () => {
  const { shell, status } = await curves({
    poses: [{ name: 'bow', time: 1, curves: [{ id: 'c', posed: BENT }] }],
  });
  expect(status).toBe(0);
  expect(shell.model('out/o.ply').positions[1]).toBeCloseTo(MODEL.positions[1]!, 12);
});

test('an output that asks for a skin is one; without it .glb is the posed model', async () => {
  const outputs = [
    { step: 's', file: 'skin.glb', skin: true },
    { step: 's', file: 'posed.glb' },
  ];
  const { shell, status, stderr } = await curves(
    { curves: [curve({ posed: BENT, anchor: 'start' })], poses: [{ name: 'rest', curves: [] }] },
    'run',
    outputs,
  );
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  const top = MODEL.positions.length - 3;
  expect(shell.model('out/skin.glb').positions[top]).toBeCloseTo(MODEL.positions[top]!, 5);
  expect(shell.model('out/posed.glb').positions[top]! - MODEL.positions[top]!).toBeGreaterThan(0.5);
  expect(shell.read('out/skin.glb')).toMatch(/"skins":.*"animations":|"animations":.*"skins":/);
});

test('a skin goes into glTF only', async () => {
  const { status, stderr } = await curves({}, 'check', [{ step: 's', file: 'o.ply', skin: true }]);
  expect(status).toBe(2);
  expect(stderr).toMatch(/outputs\[0\]\.skin: "o\.ply" cannot hold a skin; end its name in \.glb or \.gltf/);
});

describe.each(['check', 'run'])('%s refuses', (command) => {
  test.each<[string, string, object]>([
    ['too few posed points', 'curve-invalid', { curves: [curve({ posed: AXIS.slice(0, 3) })] }],
    ['too few twists', 'curve-invalid', { curves: [curve({ twist: [1] })] }],
    ['a segment that is not there', 'curve-invalid', { curves: [curve({ rigid: [4] })] }],
    ['one id twice', 'curve-invalid', { curves: [curve(), curve()] }],
    ['a link to no curve', 'curve-invalid', { links: [{ child: 'c', parent: 'd', at: 0 }] }],
    [
      'links in a ring',
      'curve-invalid',
      {
        curves: [curve(), curve({ id: 'd' })],
        links: [
          { child: 'c', parent: 'd', at: 0 },
          { child: 'd', parent: 'c', at: 0 },
        ],
      },
    ],
    ['a pose of no curve', 'curve-invalid', { poses: [{ name: 'p', curves: [{ id: 'x' }] }] }],
    ['a vertex that is not there', 'index-out-of-range', { curves: [curve({ region: [99999] })] }],
    ['a reach of what is no contour', 'curve-invalid', { curves: [curve({ reach: 1 })] }],
    ['lines held beside what is no contour', 'curve-invalid', { curves: [curve({ held: [AXIS] })] }],
    ['a reach of nothing', 'recipe-invalid', { curves: [curve({ kind: 'contour', reach: 0 })] }],
    ['a curve of one point', 'recipe-invalid', { curves: [curve({ rest: AXIS.slice(0, 1) })] }],
    ['a rotation that is none', 'recipe-invalid', { curves: [curve({ base: [0, 0, 0, 0] })] }],
  ])('%s', async (_, code, fields) => {
    const { shell, status, stderr } = await curves(fields, command);
    expect({ status, stderr }).toEqual({
      status: 2,
      stderr: expect.stringMatching(new RegExp(`^error: ${code}: steps\\[0\\][^\n]{20,}\n$`)),
    });
    expect(shell.files('out')).toEqual([]);
  });
});
