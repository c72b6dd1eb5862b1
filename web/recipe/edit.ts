// Edits that hold for every step, as pure functions: a recipe in, another out that shares whatever did not change.
// What changes nothing returns the very same recipe, so the history adds no entry.

import { produce } from 'immer';
import { freeName } from './names';
import { type ModelRef, type Recipe, type Step, type StepOf, type StepType, stepRow } from './recipe';
import { mainInput, namesOf, outputName, producedNames, referencesOf } from './references';

/** The first of `base`, `base 2`, `base 3` … that is not taken; for models, steps and handles alike. */
export function uniqueName(base: string, taken: Iterable<string>): string {
  const used = new Set(taken);
  let name = base;
  for (let n = 2; used.has(name); n++) name = `${base} ${n}`;
  return name;
}

/** An id for a new step: its kind and the first number that is free. */
export const freeId = (kind: StepType, recipe: Recipe): string => freeName(kind, takenNames(recipe));

/** Names that a new model or step must not take. */
export const takenNames = (recipe: Recipe): string[] => [
  ...Object.keys(recipe.models),
  ...recipe.steps.flatMap((step) => [...namesOf(step)]),
];

export const stepById = (recipe: Recipe, id: string): Step | undefined =>
  recipe.steps.find((step) => step.id === id);

/** The step, if it is of that type. */
export function stepOf<T extends StepType>(recipe: Recipe, id: string, type: T): StepOf<T> | undefined {
  const step = stepById(recipe, id);
  return step?.type === type ? (step as StepOf<T>) : undefined;
}

/** The steps of a type, in their order. */
export const stepsOf = <T extends StepType>({ steps }: Pick<Recipe, 'steps'>, type: T): StepOf<T>[] =>
  steps.filter((step) => step.type === type) as StepOf<T>[];

/** Puts an edited step in the place of the one with its id. */
export const replaceStep = (recipe: Recipe, step: Step): Recipe => ({
  ...recipe,
  steps: recipe.steps.map((each) => (each.id === step.id ? step : each)),
});

/** An edited step in the place of the one with its id, or a new one at the end. */
export const putStep = (recipe: Recipe, step: Step): Recipe =>
  stepById(recipe, step.id) ? replaceStep(recipe, step) : addStep(recipe, step);

export const setModel = (recipe: Recipe, name: string, ref: ModelRef): Recipe =>
  produce(recipe, (draft) => {
    draft.models[name] = ref;
  });

/** A model under a name of its own: the one given where it is free or holds the same model, else the next. */
export function withModel(recipe: Recipe, wanted: string, ref: ModelRef): { recipe: Recipe; name: string } {
  const held = Object.hasOwn(recipe.models, wanted) ? recipe.models[wanted] : undefined;
  if (held && sameRef(held, ref)) return { recipe, name: wanted };
  const name = uniqueName(wanted, takenNames(recipe));
  return { recipe: setModel(recipe, name, ref), name };
}

const sameRef = (a: ModelRef, b: ModelRef): boolean =>
  'file' in a ? 'file' in b && a.file === b.file : 'builtin' in b && a.builtin === b.builtin;

/** Removes models that no step uses. */
export const pruneModels = (recipe: Recipe): Recipe =>
  produce(recipe, (draft) => {
    const used = new Set(recipe.steps.flatMap((step) => referencesOf(step).map(({ name }) => name)));
    for (const name of Object.keys(recipe.models)) if (!used.has(name)) delete draft.models[name];
  });

export const addStep = (recipe: Recipe, step: Step): Recipe =>
  produce(recipe, (draft) => {
    draft.steps.push(step);
  });

/** Removes a step with its outputs; later steps that started from it start from what it started from. */
export function removeStep(recipe: Recipe, id: string): Recipe {
  const gone = stepById(recipe, id);
  if (!gone) return recipe;
  const left = producedNames(gone);
  const without = produce(recipe, (draft) => {
    draft.steps = draft.steps.filter((step) => step.id !== id);
    draft.outputs = draft.outputs.filter((output) => !left.includes(output.step));
  });
  return left.reduce((held, name) => redirect(held, name, replacedBy(gone, name)), without);
}

/** What one of a step's results was made of: the input that it is called after, else the one that the step changes. */
function replacedBy(step: Step, name: string): string {
  const own = outputName(step, name);
  return referencesOf(step).some((each) => each.name === own) ? own : mainInput(step);
}

/** Lets whatever names one model or step name another. */
export function redirect(recipe: Recipe, from: string, to: string): Recipe {
  return produce(recipe, (draft) => {
    for (const [at, step] of recipe.steps.entries())
      for (const { path, name } of referencesOf(step)) if (name === from) place(draft.steps[at]!, path, to);
  });
}

/**
 * Lets a new step that changes a model stand right before one that matches it with others, and its result be matched in the
 * model's place; whatever named the model as one of those that are left names the result.
 *
 * @param set  id of the step that leaves several models, called after what it starts from
 */
export function changedBefore(recipe: Recipe, set: string, step: Step): Recipe {
  const from = mainInput(step);
  const maker = stepById(recipe, set);
  if (!maker) return recipe;
  const changes = (id: string) => {
    const earlier = stepById(recipe, id);
    return earlier && mainInput(earlier);
  };
  const before = producedNames(maker);
  const changed = produce(recipe, (draft) => {
    for (const [at, each] of recipe.steps.entries()) {
      const held = draft.steps[at]!;
      const references = referencesOf(each);
      if (each.id === set)
        for (const { path, name } of references) if (name === from) place(held, path, step.id);
      if (references.some(({ name, several }) => several && name === set))
        for (const { path, name } of stepRow(each.type).members?.(each, changes) ?? [])
          if (name === from) renamed(held, path, from, step.id);
    }
    draft.steps.splice(recipe.steps.indexOf(maker), 0, step);
  });
  const after = producedNames(stepById(changed, set)!);
  const at = before.findIndex((name, each) => name !== after[each]);
  if (at < 0) return changed;
  const [was, is] = [before[at]!, after[at]!];
  const outputs = changed.outputs.map((output) => (output.step === was ? { ...output, step: is } : output));
  return redirect({ ...changed, outputs }, was, is);
}

/** Puts another name where one is: as a value, or as the key of one. */
function renamed(holder: object, path: readonly (string | number)[], from: string, to: string): void {
  let held = holder as Record<string | number, unknown>;
  for (const key of path.slice(0, -1)) held = held[key] as Record<string | number, unknown>;
  const key = path.at(-1)!;
  if (held[key] === from) held[key] = to;
  else if (key === from) {
    held[to] = held[key];
    delete held[key];
  }
}

function place(holder: object, path: readonly (string | number)[], value: string): void {
  let held = holder as Record<string | number, unknown>;
  for (const key of path.slice(0, -1)) held = held[key] as Record<string | number, unknown>;
  held[path.at(-1)!] = value;
}
