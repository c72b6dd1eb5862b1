import { beforeEach, describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { parseRecipe } from '../../web/recipe/parse';
import type { Recipe } from '../../web/recipe/recipe';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';
import { FakeKernel } from './fake-kernel';

const tetrahedron = (name: string, size: number): Model => ({
  name,
  positions: Float64Array.of(0, 0, 0, size, 0, 0, 0, size, 0, 0, 0, size),
  faceOffsets: Uint32Array.of(0, 3, 6, 9, 12),
  faceVertices: Uint32Array.of(0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3),
});
const MODELS: Readonly<Record<string, Model>> = {
  horse: tetrahedron('horse', 1),
  cow: tetrahedron('cow', 2),
};

const moved = (x: number, y: number, z: number) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
const region = (vertices: unknown, x = 0) => ({ kind: 'region', vertices, matrix: moved(x, 0, 0) });
const pose = (handles: object[] = [region([0]), region([3], 5)], more = {}) => ({
  id: 'pose',
  type: 'deform',
  model: 'horse',
  handles,
  ...more,
});
const transfer = (more = {}) => ({
  id: 'give',
  type: 'transfer',
  model: 'cow',
  like: 'pose',
  handles: [[1], [2]],
  ...more,
});
const recipeOf = (...steps: unknown[]): Recipe =>
  parseRecipe({ lissom: 1, models: { horse: { builtin: 'horse' }, cow: { builtin: 'cow' } }, steps });

let kernel: FakeKernel;
let runner: Runner;
beforeEach(() => {
  kernel = new FakeKernel();
  runner = new Runner({ kernel, models: { load: async (name) => MODELS[name]! } });
});

const given = async (recipe: Recipe) =>
  (await runner.run(recipe, { until: 'give' })).get('give') as StepResult<'transfer'>;
const codes = ({ report }: StepResult) => report.warnings.map(({ code, count }) => [code, count]);

test('the pose is run first, and given to the other model by its handles', async () => {
  const { model, inputs, report } = await given(recipeOf(pose(), transfer()));
  expect(model.name).toBe('cow');
  expect([...model.positions]).toEqual([0, 0, 0, 2, 0, 0, 5, 2, 0, 0, 0, 2]);
  expect(inputs.map((input) => input.model.name)).toEqual(['cow', 'horse']);
  expect(kernel.take()).toEqual({
    openModel: 3,
    prepareDeform: 1,
    deform: 1,
    prepareTransfer: 1,
    transfer: 1,
  });
  expect(report).toEqual({
    id: 'give',
    type: 'transfer',
    vertices: 4,
    faces: 4,
    unknowns: 40,
    iterations: 1,
    seconds: { fields: 0.1, reduce: 0.2, perIteration: 0.3, solve: 0.4 },
    peakBytes: 99,
    warnings: [],
  });
});

test('strength and stretch are asked of what is prepared already', async () => {
  const { model } = await given(recipeOf(pose(), transfer({ strength: 0.5 })));
  expect(model.positions[6]).toBe(2.5);
  await given(recipeOf(pose(), transfer({ strength: 1, keepStretch: true })));
  await given(recipeOf(pose(), transfer({ strength: 1 })));
  expect(kernel.take()).toMatchObject({ prepareDeform: 1, prepareTransfer: 1, transfer: 3 });
});

test('another pose of the same handles is given without preparing anything', async () => {
  await given(recipeOf(pose(), transfer()));
  const { model } = await given(recipeOf(pose([region([0]), region([3], 7)]), transfer()));
  expect(model.positions[6]).toBe(7);
  expect(kernel.take()).toMatchObject({ prepareTransfer: 1, transfer: 2 });
});

test('undo and names ask for nothing', async () => {
  const first = await given(recipeOf(pose(), transfer()));
  kernel.take();
  const named = pose([{ ...region([0]), name: 'hoof' }, region([3], 5)]);
  expect((await given(recipeOf(named, transfer()))).model).toBe(first.model);
  expect(kernel.take()).toEqual({});
});

test('other handles on either model are prepared anew', async () => {
  await given(recipeOf(pose(), transfer()));
  await given(recipeOf(pose(), transfer({ handles: [[1], [2, 3]] })));
  await given(recipeOf(pose([region([0]), region([2, 3], 5)]), transfer()));
  expect(kernel.take()).toMatchObject({ prepareTransfer: 3 });
});

test('a pose may start from another step, and the result be worked on further', async () => {
  const recipe = recipeOf(
    { ...pose(), id: 'first' },
    pose([region([0]), region([3], 1)], { model: 'first' }),
    transfer(),
    { ...pose([region([2], 10)]), id: 'more', model: 'give' },
  );
  const results = await runner.run(recipe);
  // Only what the step itself did to its model is given.
  expect(results.get('give')!.model.positions[6]).toBe(1);
  expect(results.get('more')!.model.positions[6]).toBe(11);
});

test('a model can be given its own pose', async () => {
  const recipe = recipeOf(pose(), transfer({ model: 'horse', handles: [[0], [3]] }));
  const { model } = await given(recipe);
  const posed = (await runner.run(recipe)).get('pose')!;
  expect(model.positions).toEqual(posed.model.positions);
});

test('after the kernel is lost everything is made anew', async () => {
  await given(recipeOf(pose(), transfer()));
  kernel.restart();
  kernel.take();
  const { model } = await given(recipeOf(pose(), transfer({ strength: 0.4 })));
  expect(model.positions[6]).toBe(2);
  expect(kernel.take()).toMatchObject({ openModel: 3, prepareTransfer: 1, transfer: 1 });
});

test('what is released in between is opened again', async () => {
  // More models than the kernel keeps open, between the pose and its transfer.
  const chain = Array.from({ length: 12 }, (_, i) => ({
    ...pose([region([1], i + 1)]),
    id: `c${i}`,
    model: i === 0 ? 'cow' : `c${i - 1}`,
  }));
  const { model } = await given(recipeOf(pose(), ...chain, transfer({ model: 'c11' })));
  expect(model.positions[6]).toBe(5);
});

describe('pairs that are missing', () => {
  const three = pose([region([0]), region([3], 5), region([2], 1)]);

  test('a handle without a counterpart is left out, and said to be', async () => {
    const result = await given(recipeOf(three, transfer({ handles: [[1], [2], []] })));
    expect(result.model.positions[6]).toBe(5);
    expect(codes(result)).toEqual([['unpaired-handle', 1]]);
  });

  test('so is one that the pose itself has emptied', async () => {
    const emptied = pose([region([0]), region([]), region([3], 5)]);
    const result = await given(recipeOf(emptied, transfer({ handles: [[1], [3], [2]] })));
    expect([...result.model.positions.slice(6)]).toEqual([5, 2, 0, 0, 0, 2]);
    expect(codes(result)).toEqual([['unpaired-handle', 1]]);
  });

  test('which of the handles is empty makes another result', async () => {
    // Of the pose alone all numbers are the same.
    const first = pose([region([0]), region([], 5), region([3], 5)]);
    const last = pose([region([0]), region([3], 5), region([], 5)]);
    const a = await given(recipeOf(first, transfer({ handles: [[0], [1], [2]] })));
    const b = await given(recipeOf(last, transfer({ handles: [[0], [1], [2]] })));
    expect([a, b].map(({ model }) => [model.positions[3], model.positions[6]])).toEqual([
      [2, 5],
      [7, 0],
    ]);
  });

  test.each([
    [[[1], [], []], 1],
    [[[], [], []], 0],
  ])('with fewer than two the model stays as it is: %j', async (handles, pairs) => {
    const result = await given(recipeOf(three, transfer({ handles })));
    expect(result.model).toBe(MODELS.cow);
    expect(codes(result)).toEqual([
      ['unpaired-handle', 3 - pairs],
      ['few-pairs', pairs],
    ]);
    expect(kernel.take()).not.toHaveProperty('prepareTransfer');
  });
});

describe('what is wrong is said before anything is computed', () => {
  test.each<[string, string, unknown[]]>([
    [
      'handle-count',
      'steps[1].handles: expected 2, one vertex set for each handle of "pose" and in their order (an empty one where ' +
        'there is no counterpart), but there are 1.',
      [pose(), transfer({ handles: [[1]] })],
    ],
    [
      'not-a-pose',
      'steps[0].like: "horse" is a model; name a deform step, whose pose is to be given.',
      [transfer({ like: 'horse' })],
    ],
    [
      'not-a-pose',
      'steps[2].like: "give" is a step of type transfer; name a deform step, whose pose is to be given.',
      [pose(), transfer(), transfer({ id: 'again', like: 'give' })],
    ],
    [
      'index-out-of-range',
      'steps[1].handles[1]: vertex 4 is out of range; "cow" has 4 vertices, numbered 0 to 3.',
      [pose(), transfer({ handles: [[1], [4]] })],
    ],
    [
      'handle-overlap',
      'steps[1].handles: the handles name 5 vertices together, but "cow" has 4; give each vertex to one handle only.',
      [pose(), transfer({ handles: ['all', [2]] })],
    ],
  ])('%s: %s', async (code, message, steps) => {
    await expect(runner.run(recipeOf(...steps))).rejects.toMatchObject({ code, message });
    expect(kernel.take()).toEqual({});
  });
});
