import fc from 'fast-check';
import { expect, test } from 'vitest';
import * as edit from '../../web/recipe/edit';
import { parseRecipe } from '../../web/recipe/parse';
import type { DeformHandle, Recipe } from '../../web/recipe/recipe';
import { anyRecipe, example, IDENTITY } from './arbitraries';

const recipe = parseRecipe(example());
const handle: DeformHandle = { kind: 'region', vertices: [1, 2], matrix: IDENTITY };
const deform = (from: Recipe, id = 'bend') => {
  const step = edit.stepById(from, id);
  if (step?.type !== 'deform') throw new Error(`no deform step ${id}`);
  return step;
};

test('edits leave the recipe they start from alone and share what they do not touch', () => {
  const before = structuredClone(recipe);
  const moved = edit.updateHandle(recipe, 'bend', 1, { matrix: IDENTITY });
  expect(recipe).toEqual(before);
  expect(deform(moved).handles[1]).toMatchObject({ matrix: IDENTITY });
  expect(deform(moved).handles[0]).toBe(deform(recipe).handles[0]);
  expect(moved.models).toBe(recipe.models);
});

test('an edit that changes nothing returns the very same recipe', () => {
  expect(edit.setRoi(recipe, 'bend', 'all')).toBe(recipe);
  expect(edit.setMethod(recipe, 'no such step', 'naive')).toBe(recipe);
  expect(edit.updateHandle(recipe, 'bend', 99, { name: 'x' })).toBe(recipe);
  expect(edit.removeHandle(recipe, 'bend', 99)).toBe(recipe);
  expect(edit.removeStep(recipe, 'no such step')).toBe(recipe);
  expect(edit.pruneModels(recipe)).toBe(recipe);
});

test('handles are added, named, hidden and removed', () => {
  const four = edit.addHandle(recipe, 'bend', handle);
  const named = edit.updateHandle(four, 'bend', 3, { name: 'tail', hidden: true });
  expect(deform(named).handles[3]).toEqual({ ...handle, name: 'tail', hidden: true });
  expect(deform(edit.updateHandle(named, 'bend', 3, { name: undefined })).handles[3]).toEqual({
    ...handle,
    hidden: true,
  });
  expect(edit.removeHandle(four, 'bend', 3)).toEqual(recipe);
});

test('a removed step is bridged: what started from it starts from what it started from', () => {
  const chain = ['a', 'b', 'c'].reduce(
    (held, id, at) => edit.addStep(held, edit.newDeformStep(id, at ? 'abc'[at - 1]! : 'bar')),
    edit.setOutputs(recipe, []),
  );
  const without = edit.setOutputs(
    edit.removeStep(edit.setOutputs(chain, [{ step: 'b', file: 'b.ply' }]), 'b'),
    [],
  );
  expect(deform(without, 'c').model).toBe('a');
  expect(parseRecipe(without)).toEqual(without);
});

test('a renamed step keeps its followers and outputs', () => {
  const two = edit.addStep(recipe, edit.newDeformStep('twist', 'bend'));
  const renamed = edit.renameStep(two, 'bend', 'bow');
  expect(deform(renamed, 'twist').model).toBe('bow');
  expect(renamed.outputs[0]!.step).toBe('bow');
  expect(edit.renameStep(renamed, 'bow', 'bend')).toEqual(two);
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
