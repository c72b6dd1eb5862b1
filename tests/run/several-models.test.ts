// Steps that leave several models, `<id>/<name>` wherever a step or an output names one. A merge step stands in for such
// a type here: it hands on what it got, each under its field's name.

import { expect, test, vi } from 'vitest';
import type { Model } from '../../web/core/model';
import { addStep, freeId, removeStep, takenNames } from '../../web/recipe/edit';
import { parseRecipe } from '../../web/recipe/parse';
import { STEP_TYPES } from '../../web/recipe/recipe';
import { mainInput, producedNames } from '../../web/recipe/references';
import { newDeformStep } from '../../web/recipe/steps/deform';
import { Runner } from '../../web/run/evaluate';
import type { StepRunner } from '../../web/run/steps/step-runner';
import { Shell } from '../cli/shell';
import { FakeKernel } from './fake-kernel';

vi.mock('../../web/run/steps/merge', () => ({
  mergeRunner: {
    check: () => {},
    vertexCount: ([source]) => source?.vertices,
    content: () => 'both',
    run: async (_, { inputs: [source, target] }) => ({
      model: target!.model,
      models: { source: source!.model, target: target!.model },
      figures: {},
      seconds: {},
      peakBytes: 0,
      warnings: [],
    }),
  } satisfies StepRunner<never>,
}));
Object.assign(STEP_TYPES.merge, { writes: 'meshes', outputs: () => ['source', 'target'] });

const shifted = (name: string, by: number): Model => ({
  name,
  positions: Float64Array.of(by, 0, 0, 1 + by, 0, 0, 0, 1, 0, 0, 0, 1),
  faceOffsets: Uint32Array.of(0, 3, 6, 9, 12),
  faceVertices: Uint32Array.of(0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3),
});
const MODELS: Readonly<Record<string, Model>> = { one: shifted('one', 0), two: shifted('two', 10) };

const pull = (vertex: number) => ({ kind: 'point', vertices: [vertex], position: [7, 7, 7] });
const document = (more: object = {}) => ({
  lissom: 1,
  models: { one: { file: 'one.ply' }, two: { file: 'two.ply' } },
  steps: [
    { id: 'both', type: 'merge', source: 'one', target: 'two' },
    { id: 'bend', type: 'deform', model: 'both/source', handles: [pull(3)] },
  ],
  outputs: [
    { step: 'both/source', file: 'a.ply' },
    { step: 'both/target', file: 'b.ply' },
    { step: 'bend', file: 'c.ply' },
  ],
  ...more,
});
const recipe = parseRecipe(document());
const runner = () => {
  const kernel = new FakeKernel();
  return { kernel, runner: new Runner({ kernel, models: { load: async (name) => MODELS[name]! } }) };
};

test('each has a name of its own, and none goes by the step’s', () => {
  expect(producedNames(recipe.steps[0]!)).toEqual(['both/source', 'both/target']);
  expect(mainInput(recipe.steps[0]!)).toBe('two');
  expect(takenNames(recipe)).toEqual(expect.arrayContaining(['both', 'both/target', 'bend']));
  expect(freeId('deform', recipe)).toBe('deform 1');
});

test.each<[place: string, message: string, more: object]>([
  [
    'steps[1].model',
    '"both" leaves several models; name one of "both/source", "both/target".',
    { steps: [document().steps[0], { ...document().steps[1], model: 'both' }] },
  ],
  [
    'steps[1].model',
    'there is no model or earlier step "both/third"; there are "one", "two", "both/source", "both/target".',
    { steps: [document().steps[0], { ...document().steps[1], model: 'both/third' }] },
  ],
  [
    'steps[0].model',
    '"both/source" is a later step (steps[1]); move it before this one.',
    { steps: document().steps.toReversed() },
  ],
  [
    'steps[2].id',
    '"both/source" is the name of an earlier step too; choose another id.',
    { steps: [...document().steps, { ...document().steps[1], id: 'both/source' }] },
  ],
  [
    'outputs[0].step',
    '"both" leaves several models; name one of "both/source", "both/target".',
    { outputs: [{ step: 'both', file: 'a.ply' }] },
  ],
  [
    'outputs[0].file',
    'cannot write "a.abc"; end its name in .obj, .ply, .stl, .glb, .gltf.',
    { outputs: [{ step: 'both/source', file: 'a.abc' }] },
  ],
])('%s: %s', (place, message, more) => {
  expect(() => parseRecipe(document(more))).toThrow(`${place}: ${message}`);
});

test('a removed step takes its outputs with it, and its followers start from what it started from', () => {
  const without = removeStep(recipe, 'both');
  expect(without.steps).toMatchObject([{ id: 'bend', model: 'two' }]);
  expect(without.outputs).toEqual([{ step: 'bend', file: 'c.ply' }]);
  expect(parseRecipe(without)).toEqual(without);
});

test('what is called after an input goes back to that one', () => {
  const named = parseRecipe(
    document({
      models: { source: { file: 'one.ply' }, target: { file: 'two.ply' } },
      steps: [{ id: 'both', type: 'merge', source: 'source', target: 'target' }],
      outputs: [],
    }),
  );
  const two = addStep(addStep(named, newDeformStep('a', 'both/source')), newDeformStep('b', 'both/target'));
  expect(removeStep(two, 'both').steps).toMatchObject([{ model: 'source' }, { model: 'target' }]);
});

test('followers run on the one they name, and only what is asked for is run', async () => {
  const { kernel, runner: own } = runner();
  const results = await own.run(recipe, { until: 'bend' });
  expect([...results.get('bend')!.model.positions]).toEqual([...MODELS.one!.positions.slice(0, 9), 7, 7, 7]);
  expect(results.get('both')).toMatchObject({
    model: MODELS.two,
    models: { source: MODELS.one, target: MODELS.two },
    report: { models: { source: { vertices: 4, faces: 4 }, target: { vertices: 4, faces: 4 } } },
  });
  expect((await own.run(recipe, { until: 'both/target' })).size).toBe(1);
  expect((await own.opened(recipe, 'both/source')).model).toBe(MODELS.one);
  expect((await own.opened(recipe, 'both')).model).toBe(MODELS.two);
  expect(kernel.take()).toMatchObject({ prepareDeform: 1, deform: 1 });
});

test('an index beyond the one that is named is refused before anything is computed', async () => {
  const { kernel, runner: own } = runner();
  const wrong = parseRecipe(
    document({ steps: [document().steps[0], { ...document().steps[1], handles: [pull(4)] }] }),
  );
  await expect(own.run(wrong)).rejects.toMatchObject({
    code: 'index-out-of-range',
    message: expect.stringContaining('"both/source" has 4 vertices'),
  });
  expect(kernel.take()).toEqual({});
});

test('the command line writes each under its own file and tells of all', async () => {
  const shell = new Shell({ kernel: async () => new FakeKernel() });
  const printed = await shell.run(document(), { 'one.ply': MODELS.one!, 'two.ply': MODELS.two! });
  expect(printed).toEqual({ status: 0, stdout: '', stderr: '' });
  const firsts = ['a.ply', 'b.ply', 'c.ply'].map((file) => shell.model(`out/${file}`).positions[0]);
  expect(firsts).toEqual([0, 10, 0]);
  const report = JSON.parse(shell.read('report.json'));
  expect(Object.keys(report.models)).toEqual(['one', 'two']);
  expect(report.steps[0]).toMatchObject({
    id: 'both',
    models: { source: { vertices: 4, faces: 4 }, target: { vertices: 4, faces: 4 } },
  });
});
