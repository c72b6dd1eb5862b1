// How a step is computed for the screen where its wing has no more to say of it, and what strategies share.

import type { Recipe, Step } from '../recipe/recipe';
import { mainInput } from '../recipe/references';
import type { ModelResult } from '../run/types';
import type { Evaluating, Outcome, Request, Strategy } from './evaluated';

/** Runs the step; what it leaves is on screen. For step types without a workspace. */
export const PLAIN: Strategy = {
  busy: 'busy.computing',
  worthWaiting: () => false,
  run: computed,
};

/** The whole result of a step that makes a new surface. */
export async function computed(
  { recipe, step }: Request,
  { runner, signal, onProgress, settle }: Evaluating,
): Promise<Outcome> {
  const results = await runner.run(recipe, { signal, onProgress, until: step.id, settle });
  const { inputs, report, strands = null } = results.get(step.id)!;
  const shown = await runner.opened(recipe, step.id, { signal });
  return { inputs, shown, positions: shown.model.positions, strands, report };
}

/** A step that changes its main input, shown before it does anything: the input as it came in. */
export async function untouched(
  { recipe, step }: Request,
  { runner, signal }: Pick<Evaluating, 'runner' | 'signal'>,
): Promise<Outcome> {
  return atRest([await runner.opened(recipe, mainInput(step), { signal })], 0);
}

/** Inputs as they came in, one of them on screen. */
export function atRest(inputs: readonly ModelResult[], shown: number): Outcome {
  const model = inputs[shown]!;
  return { inputs, shown: model, positions: model.model.positions };
}

/** Whether two requests start from the same models through the same steps. */
export function sameBefore(a: Request, b: Request): boolean {
  if (a.recipe.models !== b.recipe.models) return false;
  return sameSteps(a.recipe, b.recipe, b.step);
}

function sameSteps(a: Recipe, b: Recipe, until: Step): boolean {
  const before = a.steps.findIndex(({ id }) => id === until.id);
  return a.steps.slice(0, before).every((each, i) => each === b.steps[i]);
}
