import fc from 'fast-check';
import { expect, test } from 'vitest';
import { IDENTITY } from '../../web/core/affine';
import * as edit from '../../web/recipe/edit';
import { parseRecipe } from '../../web/recipe/parse';
import type { DeformHandle, Recipe } from '../../web/recipe/recipe';
import { newDeformStep } from '../../web/recipe/steps/deform';
import * as deformEdit from '../../web/recipe/steps/deform-edits';
import { anyRecipe, example } from './arbitraries';

const recipe = parseRecipe(example());
const handle: DeformHandle = { kind: 'region', vertices: [1, 2], matrix: [...IDENTITY] };
const deform = (from: Recipe, id = 'bend') => {
  const step = edit.stepOf(from, id, 'deform');
  if (!step) throw new Error(`no deform step ${id}`);
  return step;
};

test('edits leave the recipe they start from alone and share what they do not touch', () => {
  const before = structuredClone(recipe);
  const moved = deformEdit.updateHandle(recipe, 'bend', 1, { matrix: IDENTITY });
  expect(recipe).toEqual(before);
  expect(deform(moved).handles[1]).toMatchObject({ matrix: IDENTITY });
  expect(deform(moved).handles[0]).toBe(deform(recipe).handles[0]);
  expect(moved.models).toBe(recipe.models);
});

test('an edit that changes nothing returns the very same recipe', () => {
  expect(deformEdit.setRoi(recipe, 'bend', 'all')).toBe(recipe);
  expect(deformEdit.setMethod(recipe, 'no such step', 'naive')).toBe(recipe);
  expect(deformEdit.updateHandle(recipe, 'bend', 99, { name: 'x' })).toBe(recipe);
  expect(deformEdit.removeHandle(recipe, 'bend', 99)).toBe(recipe);
  expect(edit.removeStep(recipe, 'no such step')).toBe(recipe);
  expect(edit.pruneModels(recipe)).toBe(recipe);
});

test('handles are added, named, hidden and removed', () => {
  const bend = deform(recipe);
  const four = edit.replaceStep(recipe, { ...bend, handles: [...bend.handles, handle] });
  const named = deformEdit.updateHandle(four, 'bend', 3, { name: 'tail', hidden: true });
  expect(deform(named).handles[3]).toEqual({ ...handle, name: 'tail', hidden: true });
  expect(deform(deformEdit.updateHandle(named, 'bend', 3, { name: undefined })).handles[3]).toEqual({
    ...handle,
    hidden: true,
  });
  expect(deformEdit.removeHandle(four, 'bend', 3)).toEqual(recipe);
});

test('a removed step is bridged: what started from it starts from what it started from', () => {
  const chain = ['a', 'b', 'c'].reduce(
    (held, id, at) => edit.addStep(held, newDeformStep(id, at ? 'abc'[at - 1]! : 'bar')),
    { ...recipe, outputs: [{ step: 'b', file: 'b.ply' }] },
  );
  const without = edit.removeStep(chain, 'b');
  expect(without.outputs).toEqual([]);
  expect(deform(without, 'c').model).toBe('a');
  expect(parseRecipe(without)).toEqual(without);
});

test('models that nothing uses are pruned', () => {
  const extra = edit.setModel(recipe, 'cow', { builtin: 'cow' });
  expect(edit.pruneModels(extra)).toEqual(recipe);
});

test('whatever steps are removed, the recipe stays valid', () => {
  fc.assert(
    fc.property(anyRecipe, fc.nat(), (any, pick) => {
      const id = any.steps[pick % Math.max(1, any.steps.length)]?.id ?? 'none';
      const left = edit.pruneModels(edit.removeStep(any, id));
      expect(parseRecipe(left)).toEqual(left);
    }),
  );
});

test('a free name is the first one that is free', () => {
  expect(edit.uniqueName('bend', edit.takenNames(recipe))).toBe('bend 2');
  expect(edit.uniqueName('bend', ['bend', 'bend 2'])).toBe('bend 3');
  expect(edit.uniqueName('new', edit.takenNames(recipe))).toBe('new');
});

test('a model is changed before it is matched, and all that names it as matched follows', () => {
  const matched = parseRecipe({
    lissom: 1,
    models: { ann: { file: 'ann.obj' }, bob: { file: 'bob.obj' }, coat: { file: 'coat.obj' } },
    steps: [
      { id: 'm', type: 'match', models: ['ann', 'bob'] },
      {
        id: 'b',
        type: 'blend',
        match: 'm',
        weights: { ann: 0.25, bob: 0.75 },
        parts: [{ from: 'bob', vertices: [1] }],
      },
      { id: 'c', type: 'dress', garment: 'coat', match: 'm', from: 'ann', to: 'bob' },
      { id: 'd', type: 'deform', model: 'm/bob', roi: 'all', handles: [] },
    ],
    outputs: [{ step: 'm/bob', file: 'bob.obj' }],
  });
  const posed = edit.changedBefore(matched, 'm', newDeformStep('pose', 'bob'));
  expect(parseRecipe(JSON.stringify(posed))).toEqual(posed);
  expect(posed.steps.map(({ id }) => id)).toEqual(['pose', 'm', 'b', 'c', 'd']);
  expect(posed.steps.slice(1)).toMatchObject([
    { models: ['ann', 'pose'] },
    { weights: { ann: 0.25, pose: 0.75 }, parts: [{ from: 'pose' }] },
    { from: 'ann', to: 'pose' },
    { model: 'm/pose' },
  ]);
  expect(posed.steps[2]).not.toHaveProperty('weights.bob');
  expect(posed.outputs).toEqual([{ step: 'm/pose', file: 'bob.obj' }]);
  expect(edit.changedBefore(matched, 'none', newDeformStep('pose', 'bob'))).toBe(matched);
});
