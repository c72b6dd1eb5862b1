// Poses that can be given, and counterparts that the recipe knows by name.

import { describe, expect, test } from 'vitest';
import { firstPose, pairedByName, posesFor, withPose } from '../../web/app/transfer/poses';
import { parseRecipe } from '../../web/recipe/parse';
import type { Recipe, TransferStep } from '../../web/recipe/recipe';

const MATRIX = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const handle = (name: string, ...vertices: number[]) => ({
  kind: 'region',
  vertices,
  matrix: MATRIX,
  ...(name && { name }),
});
const pose = (id: string, model: string, ...handles: object[]) => ({ id, type: 'deform', model, handles });
const give = (id: string, handles: number[][], more = {}) => ({
  id,
  type: 'transfer',
  model: 'cow',
  like: 'a',
  handles,
  ...more,
});
const recipeOf = (...steps: object[]): Recipe =>
  parseRecipe({
    lissom: 1,
    models: { horse: { builtin: 'horse' }, cow: { builtin: 'cow' }, dog: { builtin: 'dog' } },
    steps,
  });
const transferIn = ({ steps }: Recipe, id: string) => steps.find((step) => step.id === id) as TransferStep;
const ids = (steps: readonly { id: string }[]) => steps.map(({ id }) => id);

describe('poses', () => {
  const recipe = recipeOf(
    pose('a', 'horse', handle('head', 1)),
    pose('empty', 'horse'),
    give('t', [[1]]),
    pose('after', 't', handle('', 2)),
    pose('b', 'horse', handle('head', 1)),
  );

  test('are deform steps with handles that do not start from the transfer', () => {
    expect(ids(posesFor(recipe, transferIn(recipe, 't')))).toEqual(['a', 'b']);
    expect(ids(posesFor(recipe))).toEqual(['a', 'after', 'b']);
  });

  test('begin with that of the open step, else with the last', () => {
    expect(firstPose(recipe, 'a')?.id).toBe('a');
    expect(firstPose(recipe, 'empty')?.id).toBe('b');
    expect(firstPose(recipeOf(pose('empty', 'horse')), 'empty')).toBeUndefined();
  });

  test('a later one comes before the transfer that gives it, and what follows that still follows', () => {
    const [b] = recipe.steps.slice(-1);
    const next = withPose(recipe, transferIn(recipe, 't'), b as never);
    expect(ids(next.steps)).toEqual(['a', 'empty', 'b', 't', 'after']);
    expect(transferIn(next, 't')).toMatchObject({ like: 'b', handles: [[1]] });
    expect(parseRecipe(JSON.stringify(next))).toEqual(next);
  });
});

describe('counterparts go along with another pose', () => {
  const along = (handles: object[]) => {
    const recipe = recipeOf(
      pose('a', 'horse', handle('Head', 1), handle('tail', 2)),
      pose('b', 'horse', ...handles),
      give('t', [[10], [20]]),
    );
    return transferIn(withPose(recipe, transferIn(recipe, 't'), recipe.steps[1] as never), 't').handles;
  };

  test.each<[string, object[], number[][]]>([
    ['by what is held, whatever it is called', [handle('x', 5), handle('y', 2)], [[10], [20]]],
    ['by name, in another order', [handle('tail', 7), handle('ear', 9), handle('head', 8)], [[20], [], [10]]],
    ['by order, where there are as many', [handle('', 7), handle('', 8)], [[10], [20]]],
    ['none, where nothing tells them', [handle('', 7)], [[]]],
  ])('%s', (_, handles, expected) => {
    expect(along(handles)).toEqual(expected);
  });
});

describe('by name', () => {
  const horse = pose('a', 'horse', handle('Head', 1), handle('tail', 2), handle('', 3));
  const paired = (handles: number[][], ...known: object[]) => {
    const recipe = recipeOf(horse, ...known, give('t', handles));
    return pairedByName(recipe, transferIn(recipe, 't'), 100).handles;
  };

  test('handles of a deform step on the model', () => {
    const cow = pose('cow pose', 'cow', handle('TAIL ', 20), handle('head', 10), handle('udder', 30));
    expect(paired([[], [], []], cow)).toEqual([[10], [20], []]);
  });

  test('counterparts of another transfer to the model', () => {
    expect(paired([[], [], []], give('before', [[10], [20], [30]]))).toEqual([[10], [20], []]);
  });

  test('what is paired by hand stays, and no part is given twice', () => {
    const cow = pose('cow pose', 'cow', handle('head', 10, 11), handle('tail', 20));
    expect(paired([[], [11], []], cow)).toEqual([[10], [11], []]);
  });

  test('where no name fits, as many in the same order', () => {
    const cow = pose('cow pose', 'cow', handle('', 10), handle('', 20), handle('', 30));
    expect(paired([[], [], []], cow)).toEqual([[10], [20], [30]]);
  });

  test('what is known of other models is no help', () => {
    const recipe = recipeOf(horse, pose('dog pose', 'dog', handle('head', 10)), give('t', [[], [], []]));
    const step = transferIn(recipe, 't');
    expect(pairedByName(recipe, step, 100)).toBe(step);
  });
});
