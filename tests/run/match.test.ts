// The match step on the real kernel: places however they are written, what it leaves, what it refuses.

import { beforeAll, describe, expect, test } from 'vitest';
import type { Recipe } from '../../web/recipe/recipe';
import type { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';
import { matchQuality } from '../../web/run/steps/match';
import { pointsOf } from '../kernel/balls';
import { FRUIT, fruitRunner, marks, match, recipeOf } from './fruit';

let runner: Runner;
beforeAll(async () => {
  runner = await fruitRunner();
});

const run = async (recipe: Recipe, id = 'm') => (await runner.run(recipe)).get(id) as StepResult<'match'>;

test('it leaves a skin for each model, in one connectivity, and says what they are worth', async () => {
  const { model, models, report } = await run(recipeOf(match()));
  expect(Object.keys(models!)).toEqual(['pear', 'plum']);
  expect(model).toBe(models!.pear);
  expect(models!.pear!.faceVertices).toEqual(models!.plum!.faceVertices);
  expect(report.models).toMatchObject({ plum: { vertices: model.positions.length / 3 } });
  expect(report.distance.plum!.mean).toBeLessThan(0.004);
  expect(report.markerError).toBeLessThan(1e-9);
  expect(report).toMatchObject({
    flipped: { pear: 0, plum: 0 },
    selfIntersections: { pear: 0, plum: 0 },
  });
  const quality = matchQuality(model)!;
  expect(quality.residuals.plum).toHaveLength(model.positions.length / 3);
  expect(quality.markerVertices).toHaveLength(6);
});

test('a place is the same as a vertex, on a face, or as a point', async () => {
  const [face, corner] = faceAt(FRUIT.pear.ends[0]!);
  const at = [0, 1, 2].map((each) => (each === corner ? 1 : 0));
  const point = [...pointsOf(FRUIT.plum, [FRUIT.plum.ends[1]!])];
  const rewritten = marks();
  const other = rewritten.map((pair, number) =>
    number === 0 ? [{ face, at }, pair[1]] : number === 1 ? [pair[0], { point }] : pair,
  );
  const [plain, said] = [await run(recipeOf(match())), await run(recipeOf(match({ markers: other })))];
  expect(said.models!.plum!.positions).toEqual(plain.models!.plum!.positions);
});

describe('three models', () => {
  const markers = marks().map((pair, at) => [...pair, FRUIT.fig.ends[at]!]);
  const three = { models: ['pear', 'plum', 'fig'], markers };

  test('pair by pair they have one connectivity, too, and markers are met; it is not what comes all at once', async () => {
    const [paired, joint] = [
      await run(recipeOf(match({ ...three, together: false }))),
      await run(recipeOf(match(three))),
    ];
    const { models, report } = paired;
    expect(Object.keys(models!)).toEqual(['pear', 'plum', 'fig']);
    for (const name of ['plum', 'fig']) {
      expect(models![name]!.faceVertices).toEqual(models!.pear!.faceVertices);
      expect(report.distance[name]!.mean).toBeLessThan(0.004);
    }
    expect(report.markerError).toBeLessThan(1e-9);
    expect(report.selfIntersections).toEqual({ pear: 0, plum: 0, fig: 0 });
    expect(models!.fig!.positions).not.toEqual(joint.models!.fig!.positions);
  });

  test('under way a model that has no skin yet shows none', async () => {
    const seen: boolean[][] = [];
    const onLook = ({ positions }: { positions: readonly Float64Array[] }) =>
      seen.push(positions.map(({ length }) => length > 0));
    await (await fruitRunner()).run(recipeOf(match({ ...three, together: false })), { onLook });
    expect(seen).toContainEqual([true, true, false]);
  });
});

test('two models are matched alike either way', async () => {
  const [joint, paired] = [await run(recipeOf(match())), await run(recipeOf(match({ together: false })))];
  expect(paired.models!.plum!.positions).toEqual(joint.models!.plum!.positions);
});

test('skins are models like any other for the steps that follow', async () => {
  const bend = {
    id: 'bend',
    type: 'deform',
    model: 'm/plum',
    handles: [{ kind: 'point', vertices: [0], position: [0, 2, 0] }],
  };
  const { model } = await run(recipeOf(match(), bend), 'bend');
  expect([...model.positions.subarray(0, 3)].map((x) => Math.round(1e6 * x) / 1e6)).toEqual([0, 2, 0]);
});

describe('what is wrong is said with its place', () => {
  test.each<[string, object]>([
    ['steps[0].markers: there are two; give 3 or more, or none at all.', { markers: marks(2) }],
    [
      'steps[0].markers[1]: expected 2, one place for each model in their order, but found 1.',
      { markers: [...marks(1), [4], ...marks(4)] },
    ],
    ['steps[0].markers[0][0]: vertex 9999 is out of range', { markers: [[9999, 0], ...marks(4)] }],
    [
      'A marker names face 9999, but "pear" has',
      { markers: [[{ face: 9999, at: [1, 0, 0] }, 0], ...marks(4)] },
    ],
    [
      'A marker has 4 weights on face 0 of "pear", which has 3 corners',
      { markers: [[{ face: 0, at: [1, 0, 0, 0] }, 0], ...marks(4)] },
    ],
    ['steps[0].mask: expected 2, one vertex set for each model', { mask: [[1]] }],
    ['steps[0].curves[0]: expected 2, one row of places for each model', { curves: [[[1, 2]]] }],
  ])('%s', async (sentence, wrong) => {
    await expect(run(recipeOf(match(wrong)))).rejects.toThrow(sentence);
  });

  test.each<[string, object]>([
    ['models: expected two models or more', { models: ['pear'] }],
    ['models: expected models that are all different', { models: ['pear', 'pear'] }],
    ['weights that sum to 1', { markers: [[{ face: 0, at: [1, 1, 0] }, 0]] }],
  ])('%s', (sentence, wrong) => {
    expect(() => recipeOf(match(wrong))).toThrow(sentence);
  });
});

/** A face at a vertex, and which of its corners that is. */
function faceAt(vertex: number): readonly [number, number] {
  const at = FRUIT.pear.faceVertices.indexOf(vertex);
  return [Math.floor(at / 3), at % 3];
}

test('three models get one connectivity together', async () => {
  const markers = marks().map((pair, at) => [...pair, FRUIT.fig.ends[at]!]);
  const { models: skins, report } = await run(recipeOf(match({ models: ['pear', 'plum', 'fig'], markers })));
  expect(skins!.fig!.faceVertices).toEqual(skins!.pear!.faceVertices);
  for (const name of ['pear', 'plum', 'fig'] as const)
    expect([report.distance[name]!.mean < 0.004, report.selfIntersections[name]]).toEqual([true, 0]);
});
