import * as v from 'valibot';
import { expect, test } from 'vitest';
import { STEP_TYPES, type Step } from '../../web/recipe/recipe';
import { mainInput, producedNames, producerOf, referencesOf } from '../../web/recipe/references';
import { list, reference, stepId } from '../../web/recipe/schema-parts';
import { stepType } from '../../web/recipe/step-row';
import { newDeformStep } from '../../web/recipe/steps/deform';
import { newMergeStep } from '../../web/recipe/steps/merge';

test('every row stands under the type of its schema', () => {
  for (const [type, { schema }] of Object.entries(STEP_TYPES)) expect(schema.entries.type.literal).toBe(type);
});

test('a step’s main input is the model that its result takes the place of', () => {
  expect(mainInput(newDeformStep('bend', 'body'))).toBe('body');
  expect(mainInput(newMergeStep('join', 'head', 'body'))).toBe('body');
});

test('references are found wherever a schema declares them: alone, left out, in lists', () => {
  const schema = v.strictObject({
    id: stepId,
    type: v.literal('probe'),
    models: v.pipe(list(reference), v.minLength(2)),
    like: v.optional(reference),
    others: v.optional(list(reference), []),
    name: v.string(),
  });
  const row = stepType(schema, {
    main: 'models',
    workspace: null,
    writes: 'meshes',
    outputs: ({ models }) => models,
  });
  Object.assign(STEP_TYPES, { probe: row });
  const probe = (fields: object) =>
    v.parse(schema, { id: 'p', type: 'probe', name: 'x', models: ['a', 'b'], ...fields }) as unknown as Step;
  const bare = probe({});
  expect(referencesOf(bare)).toEqual([
    { path: ['models', 0], name: 'a' },
    { path: ['models', 1], name: 'b' },
  ]);
  expect(referencesOf(probe({ like: 'c', others: ['d'] })).map(({ name }) => name)).toEqual([
    'a',
    'b',
    'c',
    'd',
  ]);
  expect(mainInput(bare)).toBe('a');
  expect(producedNames(bare)).toEqual(['p/a', 'p/b']);
  expect(producerOf({ steps: [bare] }, 'p/b')).toBe(bare);
  expect(producerOf({ steps: [bare] }, 'p')).toBeUndefined();
});
