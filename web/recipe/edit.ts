// Edits as pure functions: a recipe in, another out that shares whatever did not change. What changes nothing
// returns the very same recipe, so the history adds no entry.

import { produce } from 'immer';
import { referencesOf } from './cross-checks';
import type { DeformHandle, DeformStep, ModelRef, Recipe, Step } from './recipe';
import { DEFORM_OPTIONS } from './steps/deform';

export type HandlePatch = Partial<Pick<DeformHandle, 'name' | 'hidden'>> & {
  readonly vertices?: DeformHandle['vertices'];
  readonly matrix?: readonly number[];
  readonly position?: readonly number[];
};
export type DeformOptionsPatch = Partial<DeformStep['options']>;

/** The first of `base`, `base 2`, `base 3` … that is not taken; for models, steps and handles alike. */
export function uniqueName(base: string, taken: Iterable<string>): string {
  const used = new Set(taken);
  let name = base;
  for (let n = 2; used.has(name); n++) name = `${base} ${n}`;
  return name;
}

/** Names that a new model or step must not take. */
export const takenNames = (recipe: Recipe): string[] => [
  ...Object.keys(recipe.models),
  ...recipe.steps.map(({ id }) => id),
];

export const stepById = (recipe: Recipe, id: string): Step | undefined =>
  recipe.steps.find((step) => step.id === id);

/** The step if it is one that deforms. */
export function deformStepById(recipe: Recipe, id: string): DeformStep | undefined {
  const step = stepById(recipe, id);
  return step?.type === 'deform' ? step : undefined;
}

/** A deform step as it starts: everything may move, nothing is held yet. */
export const newDeformStep = (id: string, model: string): DeformStep => ({
  id,
  type: 'deform',
  model,
  roi: 'all',
  handles: [],
  method: 'implicit',
  options: DEFORM_OPTIONS,
});

export const setModel = (recipe: Recipe, name: string, ref: ModelRef): Recipe =>
  produce(recipe, (draft) => {
    draft.models[name] = ref;
  });

/** Removes models that no step uses. */
export const pruneModels = (recipe: Recipe): Recipe =>
  produce(recipe, (draft) => {
    const used = new Set(recipe.steps.flatMap((step) => referencesOf(step).map(({ name }) => name)));
    for (const name of Object.keys(recipe.models)) if (!used.has(name)) delete draft.models[name];
  });

/** @param at  where it goes; the end when left out */
export const addStep = (recipe: Recipe, step: Step, at = recipe.steps.length): Recipe =>
  produce(recipe, (draft) => {
    draft.steps.splice(at, 0, step);
  });

/** Removes a step with its outputs; later steps that started from it start from what it started from. */
export function removeStep(recipe: Recipe, id: string): Recipe {
  const gone = stepById(recipe, id);
  if (!gone) return recipe;
  const before = gone.type === 'merge' ? gone.target : referencesOf(gone)[0]?.name;
  const left = produce(recipe, (draft) => {
    draft.steps = draft.steps.filter((step) => step.id !== id);
    draft.outputs = draft.outputs.filter((output) => output.step !== id);
  });
  return before === undefined ? left : redirect(left, id, before);
}

/** Renames a step wherever it is named. `to` must be free (`uniqueName`). */
export function renameStep(recipe: Recipe, from: string, to: string): Recipe {
  const renamed = produce(recipe, (draft) => {
    for (const step of draft.steps) if (step.id === from) step.id = to;
    for (const output of draft.outputs) if (output.step === from) output.step = to;
  });
  return redirect(renamed, from, to);
}

export const setOutputs = (recipe: Recipe, outputs: Recipe['outputs']): Recipe =>
  produce(recipe, (draft) => {
    draft.outputs = outputs;
  });

/** Changes one deform step through a draft; any other id leaves the recipe as it is. */
export const editDeform = (recipe: Recipe, id: string, change: (step: DeformStep) => void): Recipe =>
  produce(recipe, (draft) => {
    const step = draft.steps.find((each) => each.id === id);
    if (step?.type === 'deform') change(step);
  });

export const setRoi = (recipe: Recipe, id: string, roi: DeformStep['roi']): Recipe =>
  editDeform(recipe, id, (step) => {
    step.roi = roi;
  });

export const setMethod = (recipe: Recipe, id: string, method: DeformStep['method']): Recipe =>
  editDeform(recipe, id, (step) => {
    step.method = method;
  });

export const setDeformOptions = (recipe: Recipe, id: string, options: DeformOptionsPatch): Recipe =>
  editDeform(recipe, id, (step) => {
    Object.assign(step.options, options);
  });

export const addHandle = (recipe: Recipe, id: string, handle: DeformHandle): Recipe =>
  editDeform(recipe, id, (step) => {
    step.handles.push(handle);
  });

/** @param patch  fields to set; one that is `undefined` is removed (a name) */
export const updateHandle = (recipe: Recipe, id: string, at: number, patch: HandlePatch): Recipe =>
  editDeform(recipe, id, (step) => {
    const handle = step.handles[at] as Record<string, unknown> | undefined;
    if (!handle) return;
    for (const [field, value] of Object.entries(patch)) {
      if (value === undefined) delete handle[field];
      else handle[field] = value;
    }
  });

export const removeHandle = (recipe: Recipe, id: string, at: number): Recipe =>
  editDeform(recipe, id, (step) => {
    if (at in step.handles) step.handles.splice(at, 1);
  });

/** Lets whatever names one model or step name another. */
export function redirect(recipe: Recipe, from: string, to: string): Recipe {
  return produce(recipe, (draft) => {
    for (const [at, step] of recipe.steps.entries())
      for (const { path, name } of referencesOf(step)) if (name === from) place(draft.steps[at]!, path, to);
  });
}

function place(holder: object, path: readonly (string | number)[], value: string): void {
  let held = holder as Record<string | number, unknown>;
  for (const key of path.slice(0, -1)) held = held[key] as Record<string | number, unknown>;
  held[path.at(-1)!] = value;
}
