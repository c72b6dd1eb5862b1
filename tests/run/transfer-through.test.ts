// A pose given through a match, on the real kernel: by the skins, nothing is paired.

import { beforeAll, describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import type { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';
import { FRUIT, fruitRunner, match, recipeOf } from './fruit';

type Shape = Pick<Model, 'positions'>;
const top = ({ positions }: Shape): number[] => verticesWhere(positions, (y) => y > 0.6);
const bottom = ({ positions }: Shape): number[] => verticesWhere(positions, (y) => y < -0.6);
const verticesWhere = (positions: Float64Array, holds: (y: number) => boolean) =>
  [...positions.keys()].filter((at) => at % 3 === 1 && holds(positions[at]!)).map((at) => (at - 1) / 3);

const moved = (x: number, y = 0) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, 0, 1];
/** The lower end stays, the upper one is moved. */
const pose = (x: number, more: object = {}) => ({
  id: 'pose',
  type: 'deform',
  model: 'pear',
  handles: [
    { kind: 'region', vertices: bottom(FRUIT.pear), matrix: moved(0) },
    { kind: 'region', vertices: top(FRUIT.pear), matrix: moved(x) },
  ],
  ...more,
});
const give = (more: object = {}) => ({
  id: 'give',
  type: 'transfer',
  model: 'plum',
  like: 'pose',
  through: 'm',
  ...more,
});
let runner: Runner;
beforeAll(async () => {
  runner = await fruitRunner();
});

const run = async (...steps: object[]) =>
  (await runner.run(recipeOf(match(), ...steps))) as Map<string, StepResult>;
const given = async (...steps: object[]) =>
  (await run(...steps)).get('give') as unknown as StepResult<'transfer'>;
/** How far the upper end moves along x against the lower one. */
const lean = (model: Shape, rest: Shape) => {
  const mean = (vertices: readonly number[]) =>
    vertices.reduce((sum, v) => sum + model.positions[3 * v]! - rest.positions[3 * v]!, 0) / vertices.length;
  return mean(top(rest)) - mean(bottom(rest));
};

test('the other model leans as the first does, with its own faces and nothing paired', async () => {
  const { model, report } = await given(pose(0.8), give({ keepStretch: true }));
  expect(model.faceVertices).toBe(FRUIT.plum.faceVertices);
  expect(model.positions.every(Number.isFinite)).toBe(true);
  expect(lean(model, FRUIT.plum)).toBeGreaterThan(0.4);
  expect(lean(model, FRUIT.plum)).toBeLessThan(1);
  expect(report).toMatchObject({ id: 'give', type: 'transfer', iterations: 1, warnings: [] });
  expect(report.unknowns).toBeGreaterThan(100);
  expect(Object.keys(report.seconds)).toEqual(['prepare', 'solve']);
});

test('no pose, or no strength, leaves it as it is', async () => {
  for (const steps of [
    [pose(0), give()],
    [pose(0.8), give({ strength: 0 })],
  ]) {
    const { model } = await given(...steps);
    for (let at = 0; at < model.positions.length; at++)
      expect(model.positions[at]).toBeCloseTo(FRUIT.plum.positions[at]!, 8);
  }
});

test('a model that is given its own pose has it', async () => {
  const results = await run(pose(0.5), give({ model: 'pear', keepStretch: true }));
  const posed = results.get('pose')!.model;
  const own = results.get('give')!.model;
  // The model itself, through its skin: what the skin is too coarse to say is lost.
  for (let at = 0; at < own.positions.length; at++)
    expect(Math.abs(own.positions[at]! - posed.positions[at]!)).toBeLessThan(0.08);
});

test('strength changes nothing that is prepared; a pose of a skin is given to a skin', async () => {
  const half = await given(pose(0.8), give({ strength: 0.5, keepStretch: true }));
  const whole = await given(pose(0.8), give({ keepStretch: true }));
  expect(lean(half.model, FRUIT.plum)).toBeGreaterThan(0.3 * lean(whole.model, FRUIT.plum));
  expect(lean(half.model, FRUIT.plum)).toBeLessThan(0.7 * lean(whole.model, FRUIT.plum));

  const skins = (await run()).get('m')!.models!;
  const onSkin = pose(0, {
    model: 'm/pear',
    handles: [
      { kind: 'region', vertices: bottom(skins.pear!), matrix: moved(0) },
      { kind: 'region', vertices: top(skins.pear!), matrix: moved(0.8) },
    ],
  });
  const { model } = await given(onSkin, give({ model: 'm/plum', keepStretch: true }));
  expect(model.positions).toHaveLength(skins.plum!.positions.length);
  expect(lean(model, skins.plum!)).toBeGreaterThan(0.4);
});

test('a pose of curves is one, too', async () => {
  const rest = [-0.9, -0.5, 0, 0.5, 0.9].map((y) => [0, y, 0]);
  const posed = rest.map(([x, y, z]) => [x! + 0.25 * (y! + 0.9) ** 2, y, z]);
  const curve = { id: 'c', kind: 'skeleton', rest, posed, anchor: 'start' };
  const bent = { id: 'pose', type: 'curves', model: 'pear', curves: [curve] };
  const { model } = await given(bent, give({ keepStretch: true }));
  expect(lean(model, FRUIT.plum)).toBeGreaterThan(0.3);
});

test('another model of the same match is another result', async () => {
  const plum = await given(pose(0.8), give());
  const pear = await given(pose(0.8), give({ model: 'pear' }));
  expect(pear.model.positions).not.toEqual(plum.model.positions);
  expect(pear.model.positions).toHaveLength(FRUIT.pear.positions.length);
});

describe('refused', () => {
  test.each<[string, object[]]>([
    ['recipe-invalid', [pose(1), give({ model: 'fig' })]],
    ['recipe-invalid', [pose(1, { model: 'fig', handles: [] }), give()]],
    ['recipe-invalid', [pose(1), give({ through: 'pear' })]],
    ['recipe-invalid', [pose(1), give({ through: 'pose' })]],
    ['not-a-pose', [pose(1), give({ like: 'pear' })]],
    ['not-a-pose', [pose(1), give({ like: 'm/pear' })]],
    ['handle-count', [pose(1), give({ handles: [[1], [2]] })]],
    ['handle-count', [pose(1), give({ through: undefined })]],
  ])('%s %#', async (code, steps) => {
    await expect(async () => run(...steps)).rejects.toMatchObject({ code });
  });
});
