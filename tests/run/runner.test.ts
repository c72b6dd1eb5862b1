import { beforeEach, describe, expect, test } from 'vitest';
import { LissomError } from '../../web/core/errors';
import type { Model } from '../../web/core/model';
import { parseRecipe } from '../../web/recipe/parse';
import type { Recipe } from '../../web/recipe/recipe';
import * as edit from '../../web/recipe/steps/deform-edits';
import { Runner } from '../../web/run/evaluate';
import { PlacedError } from '../../web/run/types';
import { FakeKernel } from './fake-kernel';

const tetrahedron = (name: string, shift = 0): Model => ({
  name,
  positions: Float64Array.of(0, 0, 0, 1 + shift, 0, 0, 0, 1, 0, 0, 0, 1),
  faceOffsets: Uint32Array.of(0, 3, 6, 9, 12),
  faceVertices: Uint32Array.of(0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3),
});

const MODELS: Readonly<Record<string, Model>> = { one: tetrahedron('one'), two: tetrahedron('two', 1) };
const models = {
  load: async (_: string, ref: { file?: string; builtin?: string }) => {
    const model = MODELS[ref.builtin ?? ''];
    if (!model) throw new LissomError('model-not-found', 'Not there.');
    return model;
  },
};

const shift = (x: number, y = 0, z = 0) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
const region = (vertices: unknown, matrix = shift(0)) => ({ kind: 'region', vertices, matrix });
const step = (id: string, model: string, handles: unknown[], more = {}) => ({
  id,
  type: 'deform',
  model,
  handles,
  ...more,
});
const recipeOf = (...steps: unknown[]): Recipe =>
  parseRecipe({ lissom: 1, models: { a: { builtin: 'one' }, b: { builtin: 'two' } }, steps });

const simple = recipeOf(step('bend', 'a', [region([0]), region([3], shift(0, 0, 2))]));
const moved = (recipe: Recipe, x: number) =>
  edit.updateHandle(recipe, recipe.steps[0]!.id, 1, { matrix: shift(x) });

let kernel: FakeKernel;
let runner: Runner;
beforeEach(() => {
  kernel = new FakeKernel();
  runner = new Runner({ kernel, models });
});

test('a step gives its model with other positions and a report', async () => {
  const { bend } = Object.fromEntries(await runner.run(simple));
  expect([...bend!.model.positions.slice(9)]).toEqual([0, 0, 3]);
  expect(bend!.model.faceVertices).toBe(MODELS.one!.faceVertices);
  expect(bend!.inputs[0]!.model).toBe(MODELS.one);
  expect(bend!.report).toEqual({
    id: 'bend',
    type: 'deform',
    vertices: 4,
    faces: 4,
    free: 5,
    degenerate: 2,
    iterations: 1,
    seconds: { assemble: 0.1, factor: 0.2, solve: 0.3, rotate: 0.4, reconstruct: 0.5 },
    peakBytes: 99,
    warnings: [],
  });
});

describe('nothing is computed twice', () => {
  test('a drag opens and factors once, then only asks for other targets', async () => {
    for (let x = 0; x < 10; x++) {
      const result = (await runner.run(moved(simple, x), { until: 'bend' })).get('bend')!;
      expect(result.model.positions[9]).toBe(x);
    }
    expect(kernel.take()).toEqual({ openModel: 1, prepareDeform: 1, deform: 10 });
  });

  test('undo, and whatever is only for the eye, asks for nothing', async () => {
    const first = await runner.run(simple);
    await runner.run(moved(simple, 4));
    kernel.take();
    const again = await runner.run(simple);
    expect(again.get('bend')!.model).toBe(first.get('bend')!.model);
    await runner.run(edit.updateHandle(simple, 'bend', 1, { name: 'tail', hidden: true }));
    await runner.run({ ...simple, steps: [{ ...simple.steps[0]!, id: 'bow' }] });
    expect(kernel.take()).toEqual({});
  });

  test('a preview is never taken for the settled result', async () => {
    await runner.run(simple, { settle: false });
    await runner.run(simple);
    expect(kernel.take()).toEqual({ openModel: 1, prepareDeform: 1, deform: 2 });
  });

  test('other vertices, region, method or options are factored anew', async () => {
    const changed = [
      edit.updateHandle(simple, 'bend', 1, { vertices: [2, 3] }),
      edit.setRoi(simple, 'bend', [0, 1, 3]),
      edit.setMethod(simple, 'bend', 'naive'),
      edit.setDeformOptions(simple, 'bend', { removeShear: false }),
    ];
    for (const recipe of [simple, ...changed]) await runner.run(recipe);
    expect(kernel.take()).toMatchObject({ openModel: 1, prepareDeform: 5 });
  });

  test('of factored systems the three used last are kept, and the others freed', async () => {
    const sets = [[1], [2], [3], [1, 2], [1, 3]].map((set) =>
      edit.updateHandle(simple, 'bend', 1, { vertices: set }),
    );
    for (const recipe of sets) await runner.run(recipe);
    expect(kernel.held.sessions).toBe(3);
    kernel.take();
    for (const recipe of sets.slice(2)) await runner.run(moved(recipe, 7));
    expect(kernel.take()).toEqual({ deform: 3 });
  });

  test('equal geometry is opened once, but each result keeps its own model’s name', async () => {
    const twin = { ...MODELS.one!, name: 'twin', positions: MODELS.one!.positions.slice() };
    const twins = new Runner({
      kernel,
      models: { load: async (name) => (name === 'a' ? MODELS.one! : twin) },
    });
    const handles = [region([0], shift(1))];
    const results = await twins.run(recipeOf(step('x', 'a', handles), step('y', 'b', handles)));
    expect([results.get('x')!.model.name, results.get('y')!.model.name]).toEqual(['one', 'twin']);
    expect(kernel.take()).toMatchObject({ openModel: 1, prepareDeform: 1 });
  });
});

describe('steps in a row', () => {
  const chain = recipeOf(
    step('first', 'a', [region([1], shift(1))]),
    step('aside', 'b', [region([1], shift(5))]),
    step('second', 'first', [region([1], shift(1))]),
  );

  test('a later step starts from what an earlier one left', async () => {
    const results = await runner.run(chain);
    expect(results.get('second')!.model.positions[3]).toBe(3);
    expect(results.get('second')!.inputs[0]!.model).toBe(results.get('first')!.model);
  });

  test('only what the wanted step depends on is run', async () => {
    expect([...(await runner.run(chain, { until: 'second' })).keys()]).toEqual(['first', 'second']);
    expect([...(await runner.run(chain, { until: 'aside' })).keys()]).toEqual(['aside']);
  });

  test('the model a step starts from can be had without running the step', async () => {
    expect((await runner.inputs(chain, 'second'))[0]!.model.positions[3]).toBe(2);
    expect((await runner.inputs(chain, 'first'))[0]!.model).toBe(MODELS.one);
    expect((await runner.opened(chain, 'b')).model).toBe(MODELS.two);
    await expect(runner.inputs(chain, 'nowhere')).rejects.toMatchObject({ code: 'step-not-found' });
  });

  test('progress runs from step to step up to one', async () => {
    const seen: [number, string][] = [];
    await runner.run(chain, { onProgress: (fraction, { id }) => seen.push([fraction, id]) });
    expect(seen).toEqual([
      [1 / 3, 'first'],
      [2 / 3, 'aside'],
      [1, 'second'],
    ]);
  });
});

test('a point handle asks for the translation that places its vertex', async () => {
  const recipe = recipeOf(step('pull', 'a', [{ kind: 'point', vertices: [3], position: [7, 8, 9] }]));
  expect([...(await runner.run(recipe)).get('pull')!.model.positions.slice(9)]).toEqual([7, 8, 9]);
});

test('a step that nothing holds leaves its model as it is and says so', async () => {
  for (const handles of [[], [region([])], [region({ ranges: [] })]]) {
    const result = (await runner.run(recipeOf(step('idle', 'a', handles)))).get('idle')!;
    expect(result.model).toBe(MODELS.one);
    expect(result.report.warnings.map(({ code }) => code)).toContain('no-handle');
    expect(Object.keys(result.report.seconds)).toEqual([
      'assemble',
      'factor',
      'solve',
      'rotate',
      'reconstruct',
    ]);
  }
  expect(kernel.take()).toEqual({ openModel: 1 });
});

test('a handle without vertices is passed over and the others work', async () => {
  const recipe = recipeOf(step('bend', 'a', [region([]), region([3], shift(1))]));
  const { report, model } = (await runner.run(recipe)).get('bend')!;
  expect(model.positions[9]).toBe(1);
  expect(report.warnings).toMatchObject([{ code: 'empty-handle', count: 1 }]);
});

test('what the last step did is measured on demand, once', async () => {
  expect((await runner.run(simple)).get('bend')!.measured).toBeUndefined();
  expect((await runner.run(simple, { measure: true })).get('bend')!.measured).toMatchObject({
    volumeRatio: 1,
  });
  await runner.run(simple, { measure: true });
  expect(kernel.take()).toMatchObject({ measure: 1 });
});

describe('before anything is computed', () => {
  test.each([
    ['steps[1].handles[1].vertices: vertex 4', step('s', 'a', [region([0]), region([1, 4])])],
    ['steps[1].roi: vertex 90', step('s', 'a', [region([0])], { roi: { ranges: [[0, 90]] } })],
    [
      'steps[1].roi: vertex 4000000000',
      step('s', 'a', [region([0])], { roi: { ranges: [[2, 4_000_000_000]] } }),
    ],
    ['"first" has 4 vertices, numbered 0 to 3.', step('s', 'first', [region([4])])],
  ])('an index out of range is refused: %s', async (message, wrong) => {
    const recipe = recipeOf(step('first', 'a', [region([0])]), wrong);
    await expect(runner.run(recipe)).rejects.toMatchObject({ code: 'index-out-of-range', fault: 'input' });
    await expect(runner.run(recipe)).rejects.toThrow(message);
    expect(kernel.take()).toEqual({});
  });

  test('a model that cannot be loaded is refused with its name', async () => {
    const recipe = parseRecipe({
      lissom: 1,
      models: { a: { builtin: 'nowhere' } },
      steps: [step('s', 'a', [])],
    });
    const error = await runner.run(recipe).catch((thrown) => thrown);
    expect(error).toBeInstanceOf(PlacedError);
    expect(error).toMatchObject({ code: 'model-not-found', place: 'models.a (nowhere)' });
  });
});

describe('when the worker goes', () => {
  test('between runs, everything is opened and prepared anew', async () => {
    await runner.run(simple);
    kernel.restart();
    await runner.run(moved(simple, 3));
    expect(kernel.take()).toEqual({ openModel: 2, prepareDeform: 2, deform: 2 });
  });

  test('in the middle of a run, the run starts over by itself', async () => {
    let left = 1;
    kernel.before = (method) => {
      if (method === 'deform' && left-- > 0) kernel.restart();
    };
    const result = (await runner.run(simple)).get('bend')!;
    expect(result.model.positions[11]).toBe(3);
    expect(kernel.take()).toEqual({ openModel: 2, prepareDeform: 2, deform: 2 });
  });

  test('again and again, the run gives up', async () => {
    kernel.before = (method) => {
      if (method === 'deform') kernel.restart();
    };
    await expect(runner.run(simple)).rejects.toMatchObject({ code: 'worker-restarted' });
    expect(kernel.take()).toMatchObject({ deform: 3 });
  });

  test('because of the step itself, it is not tried again', async () => {
    kernel.before = (method) => {
      if (method !== 'deform') return;
      kernel.restart();
      throw new LissomError('out-of-memory', 'Too much.', 'memory');
    };
    const error = await runner.run(simple).catch((thrown) => thrown);
    expect(error).toMatchObject({ code: 'out-of-memory', place: 'steps[0] (bend)', message: 'Too much.' });
    expect(kernel.take()).toMatchObject({ deform: 1 });
  });
});

test('a cancelled run stops, and the next one works', async () => {
  const abort = new AbortController();
  kernel.before = (method) => {
    if (method === 'prepareDeform') abort.abort();
  };
  await expect(runner.run(simple, { signal: abort.signal })).rejects.toMatchObject({ code: 'cancelled' });
  await expect(runner.run(simple, { signal: abort.signal })).rejects.toMatchObject({ code: 'cancelled' });
  kernel.before = () => {};
  expect((await runner.run(simple)).size).toBe(1);
});

test('runs asked for at once follow each other and share what they open', async () => {
  const runs = [0, 1, 2].map((x) => runner.run(moved(simple, x)));
  const ends = (await Promise.all(runs)).map((results) => results.get('bend')!.model.positions[9]);
  expect(ends).toEqual([0, 1, 2]);
  expect(kernel.take()).toEqual({ openModel: 1, prepareDeform: 1, deform: 3 });
});
