// What has to be done for a result: the steps it depends on, their models, and whether all indices fit.

import { LissomError } from '../core/errors';
import type { Model } from '../core/model';
import { vertexCount } from '../core/model';
import { pathText } from '../recipe/problem';
import type { ModelRef, Recipe, Step } from '../recipe/recipe';
import { namesOf, producedNames, referencesOf } from '../recipe/references';
import { runnerOf } from './steps/all';
import type { InputShape } from './steps/step-runner';
import { type ModelSource, placed } from './types';

export interface Plan {
  /** Steps to run, in order, with their place in the recipe. */
  readonly steps: readonly { readonly step: Step; readonly index: number }[];
  /** The models they start from, by name. */
  readonly models: ReadonlyMap<string, Model>;
}

/**
 * Loads what is needed and checks every index before anything is computed.
 *
 * @param wanted  steps by their ids, or what models and results are called; all steps when left out
 * @throws LissomError `index-out-of-range`, `step-not-found`, or what the source says of a model
 */
export async function plan(recipe: Recipe, source: ModelSource, wanted?: readonly string[]): Promise<Plan> {
  const steps = needed(recipe, wanted);
  const models = new Map<string, Model>();
  const names = steps.flatMap(({ step }) => referencesOf(step).map(({ name }) => name));
  for (const name of [...names, ...(wanted ?? [])]) {
    const ref = Object.hasOwn(recipe.models, name) ? recipe.models[name] : undefined;
    if (ref && !models.has(name))
      models.set(name, await placed(modelPlace(name, ref), () => source.load(name, ref)));
  }
  checkIndices(steps, models);
  return { steps, models };
}

export const stepPlace = (index: number, step: Step): string => `${pathText(['steps', index])} (${step.id})`;

export const modelPlace = (name: string, ref: ModelRef): string =>
  `${pathText(['models', name])} (${'file' in ref ? ref.file : ref.builtin})`;

function needed(recipe: Recipe, names: readonly string[] | undefined): Plan['steps'] {
  const all = recipe.steps.map((step, index) => ({ step, index }));
  if (names === undefined) return all;
  for (const name of names)
    if (!Object.hasOwn(recipe.models, name) && !all.some(({ step }) => namesOf(step).has(name)))
      throw new LissomError('step-not-found', `There is no step ${JSON.stringify(name)} in the recipe.`);
  const wanted = new Set(names);
  // Backwards: a step only refers to earlier ones.
  return all
    .toReversed()
    .filter(({ step }) => {
      if (![...namesOf(step)].some((name) => wanted.has(name))) return false;
      for (const { name } of referencesOf(step)) wanted.add(name);
      return true;
    })
    .toReversed();
}

function checkIndices(steps: Plan['steps'], models: ReadonlyMap<string, Model>): void {
  const shapes = new Map<string, InputShape>();
  for (const [name, model] of models) shapes.set(name, { name, vertices: vertexCount(model) });
  for (const { step, index } of steps) {
    const inputs = referencesOf(step).map(({ name }) => shapes.get(name));
    const runner = runnerOf(step);
    runner.check(step, pathText(['steps', index]), inputs);
    const vertices = runner.vertexCount(inputs);
    if (vertices !== undefined)
      for (const name of producedNames(step)) shapes.set(name, { name, vertices, maker: step });
  }
}
