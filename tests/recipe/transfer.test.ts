import { describe, expect, test } from 'vitest';
import { removeStep } from '../../web/recipe/edit';
import { decodeLink, encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import { mainInput, referencesOf } from '../../web/recipe/references';
import { newTransferStep } from '../../web/recipe/steps/transfer';

const point = (vertex: number) => ({ kind: 'point', vertices: [vertex], position: [0, 1, 2] });
const document = (more: object = {}) => ({
  lissom: 1,
  models: { horse: { builtin: 'horse' }, cow: { builtin: 'cow' } },
  steps: [
    { id: 'pose', type: 'deform', model: 'horse', handles: [point(1), point(2)] },
    {
      id: 'give',
      type: 'transfer',
      model: 'cow',
      like: 'pose',
      handles: [[3, 4], { ranges: [[7, 9]] }],
      ...more,
    },
  ],
  outputs: [{ step: 'give', file: 'cow.ply' }],
});

test('what is left out has its default', () => {
  expect(parseRecipe(document()).steps[1]).toEqual({
    ...document().steps[1],
    strength: 1,
    keepStretch: false,
  });
});

test('it changes the model and names the pose', () => {
  const step = newTransferStep('give', 'cow', 'pose', 2);
  expect(step.handles).toEqual([[], []]);
  expect(mainInput(step)).toBe('cow');
  expect(referencesOf(step).map(({ name }) => name)).toEqual(['cow', 'pose']);
});

test('a link carries it', () => {
  const recipe = parseRecipe(document({ strength: 0.8, keepStretch: true }));
  expect(decodeLink(encodeLink(recipe))).toEqual(recipe);
});

test('without its pose the recipe can still be read', () => {
  const without = removeStep(parseRecipe(document()), 'pose');
  expect(without.steps).toMatchObject([{ id: 'give', model: 'cow', like: 'horse' }]);
  expect(parseRecipe(without)).toEqual(without);
});

describe('bounds', () => {
  test.each([
    [{ strength: -0.1 }, 'steps[1].strength: expected a number from 0 to 2, found -0.1.'],
    [{ strength: 2.5 }, 'steps[1].strength: expected a number from 0 to 2, found 2.5.'],
    [{ handles: [[3], 'some'] }, 'steps[1].handles[1]'],
    [{ like: 'nobody' }, 'steps[1].like: there is no model or earlier step "nobody"'],
    [{ like: 'give' }, 'steps[1].like: "give" is the step itself'],
    [{ pose: 'pose' }, 'steps[1]'],
  ])('%j', (more, message) => {
    expect(() => parseRecipe(document(more))).toThrow(message);
  });
});

describe('through a match', () => {
  const through = (more: object = {}) => {
    const { models, steps, ...rest } = document();
    const match = { id: 'm', type: 'match', models: ['horse', 'cow'] };
    const give = { id: 'give', type: 'transfer', model: 'cow', like: 'pose', through: 'm', ...more };
    return {
      ...rest,
      models: { ...models, dog: { builtin: 'dog' } },
      steps: [match, steps[0], { id: 'of-dog', type: 'deform', model: 'dog', handles: [] }, give],
    };
  };

  test('handles are left out, and a link carries it', () => {
    const recipe = parseRecipe(through());
    expect(recipe.steps[3]).toMatchObject({ through: 'm', handles: [] });
    expect(referencesOf(recipe.steps[3]!).map(({ name }) => name)).toEqual(['cow', 'pose', 'm']);
    expect(decodeLink(encodeLink(recipe))).toStrictEqual(recipe);
  });

  test('skins of the match are its models, too', () => {
    expect(() => parseRecipe(through({ model: 'm/cow' }))).not.toThrow();
  });

  test.each([
    [{ model: 'dog' }, 'steps[3].model: "m" has no model "dog"; it has "horse", "cow".'],
    [{ like: 'of-dog' }, 'steps[3].like: "m" has no model "dog"; it has "horse", "cow".'],
    [
      { through: 'horse' },
      'steps[3].through: "horse" is a model; name an earlier step that leaves several: "m".',
    ],
  ])('%j', (more, message) => {
    expect(() => parseRecipe(through(more))).toThrow(message);
  });
});
