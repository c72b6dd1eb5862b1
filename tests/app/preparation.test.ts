// What is about to be set up is said where progress is shown.

import { signal } from '@preact/signals';
import { beforeAll, expect, test } from 'vitest';
import { deformStrategy } from '../../web/app/deform/evaluation';
import type { Evaluating, Request } from '../../web/app/evaluated';
import { addWords } from '../../web/app/i18n';
import words from '../../web/app/locales/en/deform.json';
import { parseRecipe } from '../../web/recipe/parse';
import type { DeformStep } from '../../web/recipe/recipe';
import type { AskOptions, RunOptions } from '../../web/run/evaluate';

const handle = (vertices: number[]) => ({
  kind: 'region',
  vertices,
  matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
});
const recipe = parseRecipe({
  lissom: 1,
  models: { scan: { builtin: 'scan' } },
  steps: [
    { id: 'd', type: 'deform', model: 'scan', method: 'isolines', handles: [handle([0]), handle([5])] },
  ],
});
beforeAll(() => addWords(words));
const PREPARED = { vertices: 1_081_346, bytes: 540e6 };

test.each([
  ['settled', false],
  ['dragged', true],
])('vertices and memory are said before a large model is prepared (%s)', async (_, live) => {
  const said: string[] = [];
  // The work is not done: it is about what is said before it.
  const stop = new Error('far enough');
  const begin = (options: RunOptions | AskOptions = {}) => {
    options.onPreparation?.(PREPARED, recipe.steps[0]!);
    return Promise.reject(stop);
  };
  const evaluating = {
    runner: {
      run: (_recipe: unknown, options?: RunOptions) => begin(options),
      ask: (...args: readonly unknown[]) => begin(args[4] as AskOptions),
      opened: async () => ({}),
    },
    signal: new AbortController().signal,
    onProgress: () => {},
    say: (label: string) => void said.push(label),
    settle: !live,
    before: null,
    show: () => {},
  } as unknown as Evaluating;
  const request: Request<DeformStep> = { recipe, step: recipe.steps[0] as DeformStep, live, wish: '' };
  await expect(deformStrategy({ movable: signal(true) }).run(request, evaluating)).rejects.toBe(stop);
  expect(said).toEqual(['Preparing 1,081,350 vertices (about 540 MB)']);
});
