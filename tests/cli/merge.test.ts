// Merging from the command line: what the report says, and what is said of loops and regions that cannot work.

import { existsSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { writeModel } from '../../web/io/formats';
import { bowl, dome, tube } from '../kernel/tubes';
import { topologyOf } from '../run/surface-measures';
import { ball, modelOf, torus } from './shapes';
import { Shell } from './shell';

const upTo = (count: number) => Array.from({ length: count }, (_, i) => i);
const closed = (n: number, m: number): Model => ({ name: 'source', ...tube(n, m, dome) });
const open = (n: number, m: number): Model => ({ name: 'target', ...tube(n, m, bowl, false) });
const SOURCE = closed(16, 20);
const TARGET = open(16, 30);
const BOUNDARY = { source: upTo(20), target: upTo(30), keys: [[0, 0]] };
const above = ({ positions }: Model, y: number) =>
  upTo(positions.length / 3).filter((v) => positions[3 * v + 1]! > y);

/** Runs a merge; the models lie beside the recipe. */
async function merge(step: object, source = SOURCE, target = TARGET) {
  const shell = new Shell();
  shell.write('s.ply', writeModel(source, 'ply'));
  shell.write('t.ply', writeModel(target, 'ply'));
  const recipe = shell.write('r.json', {
    lissom: 1,
    models: { s: { file: 's.ply' }, t: { file: 't.ply' } },
    steps: [{ id: 'm', type: 'merge', source: 's', target: 't', ...step }],
    outputs: [{ step: 'm', file: 'm.ply' }],
  });
  const told = await shell.lissom([
    'run',
    recipe,
    '--out',
    shell.path('out'),
    '--report',
    shell.path('report.json'),
  ]);
  return { shell, ...told };
}

async function merged(step: object, source?: Model, target?: Model) {
  const { shell, status, stderr } = await merge(step, source, target);
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  return { model: shell.model('out/m.ply'), report: JSON.parse(shell.read('report.json')) };
}

/** One line that begins with the code and says what to do, and nothing written. */
async function refused(code: string, step: object, source?: Model, target?: Model) {
  const { shell, status, stderr } = await merge(step, source, target);
  expect({ status, stderr }).toEqual({
    status: 2,
    stderr: expect.stringMatching(new RegExp(`^error: ${code}: steps\\[0\\] \\(m\\): [A-Z][^\n]{30,}\\.\n$`)),
  });
  expect([shell.files('out'), existsSync(shell.path('report.json'))]).toEqual([[], false]);
}

const CLOSED = { twice: 0, open: 0, pieces: 1, euler: 2 };

describe('merging from the command line', () => {
  test('the report lists both models and how the seam looks', async () => {
    const { report } = await merged({ boundaries: [BOUNDARY] });
    expect(report.models).toMatchObject({
      s: { vertices: 16 * 20 + 1, boundaryLoops: 1, closed: false },
      t: { vertices: 16 * 30 + 1, boundaryLoops: 1, closed: false },
    });
    expect(report.steps[0].seam).toEqual({
      medianDihedral: expect.any(Number),
      highDihedral: expect.any(Number),
      maxDihedral: expect.any(Number),
      ownHighDihedral: expect.any(Number),
      leastAngle: expect.any(Number),
    });
  });

  test('loops given in opposite directions come to the same as loops given alike', async () => {
    const { model } = await merged({ boundaries: [BOUNDARY] });
    const other = await merged({ boundaries: [{ ...BOUNDARY, source: upTo(20).reverse() }] });
    expect(topologyOf(model)).toEqual(CLOSED);
    expect(topologyOf(other.model)).toEqual(CLOSED);
    expect(other.model.positions.length).toBe(model.positions.length);
  });

  test('a loop of three vertices is refined to meet one of three hundred', async () => {
    const boundary = { source: upTo(3), target: upTo(300), keys: [[0, 0]] };
    const { model, report } = await merged({ boundaries: [boundary] }, closed(5, 3), open(30, 300));
    expect(topologyOf(model)).toEqual(CLOSED);
    const [{ warnings, seam }] = report.steps;
    expect(warnings.map(({ code }: { code: string }) => code)).toContain('boundary-refined');
    expect(seam.leastAngle).toBeGreaterThan(1);
  });

  test('a loop that touches itself is refused', () =>
    refused('loop-touches-itself', { boundaries: [{ ...BOUNDARY, source: [0, 1, 2, 22, 21, 1, 20] }] }));

  test('keys out of order are refused', () =>
    refused('keys-out-of-order', {
      boundaries: [
        {
          ...BOUNDARY,
          keys: [
            [0, 0],
            [5, 8],
            [10, 22],
            [15, 15],
          ],
        },
      ],
    }));

  test('a path that does not part the model is refused', () =>
    refused('loop-not-separating', { boundaries: [{ ...BOUNDARY, source: upTo(20) }] }, torus(40, 20)));

  test('a loop along faces that three share an edge of is refused', () => {
    const { positions, faceOffsets, faceVertices } = SOURCE;
    const points = upTo(positions.length / 3).map(
      (v) => [...positions.subarray(3 * v, 3 * v + 3)] as [number, number, number],
    );
    const faces = upTo(faceOffsets.length - 1).map((f) => [...faceVertices.subarray(3 * f, 3 * f + 3)]);
    const fin = modelOf(
      'fin',
      [...points, [3, 1, 0], [3, 1.2, 0.3]],
      [...faces, [20, 21, 321], [20, 21, 322]],
    );
    return refused(
      'loop-non-manifold',
      { boundaries: [{ ...BOUNDARY, source: upTo(20).map((v) => v + 20) }] },
      fin,
    );
  });
});

describe('painted regions', () => {
  const [source, target] = [ball(40, 48), ball(36, 40)];
  const regions = {
    sourceRegion: above(source, 0),
    feature: above(source, 0.6),
    targetRegion: above(target, -0.2),
  };
  const painted = (change: object) => ({ optimalBoundary: { ...regions, ...change } });

  test('that fit give one closed model', async () => {
    const { model } = await merged(painted({}), source, target);
    expect(topologyOf(model)).toEqual(CLOSED);
  });

  test('a feature that touches the edge of its region is refused', () =>
    refused('region-touches-feature', painted({ feature: above(source, 0) }), source, target));

  test('a region that is no ring around the feature is refused', () => {
    const holed = regions.sourceRegion.filter((v) => {
      const [x, y] = source.positions.subarray(3 * v, 3 * v + 2) as unknown as [number, number];
      return !(x > 0.5 && y > 0.2 && y < 0.45);
    });
    return refused('region-not-a-ring', painted({ sourceRegion: holed }), source, target);
  });

  test('a target region with a hole is refused', () => {
    const holed = regions.targetRegion.filter((v) => !(target.positions[3 * v + 1]! > 0.8));
    return refused('target-region-not-a-disk', painted({ targetRegion: holed }), source, target);
  });
});
