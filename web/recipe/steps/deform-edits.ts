// Edits of one deform step; any other id leaves the recipe as it is.

import { produce } from 'immer';
import type { Recipe } from '../recipe';
import type { DeformHandle, DeformStep } from './deform';

export type HandlePatch = Partial<Pick<DeformHandle, 'name' | 'hidden'>> & {
  readonly vertices?: DeformHandle['vertices'];
  readonly matrix?: readonly number[];
  readonly position?: readonly number[];
};
export type DeformOptionsPatch = Partial<DeformStep['options']>;

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

/** Through a draft, so that what the change leaves alone is shared. */
const editDeform = (recipe: Recipe, id: string, change: (step: DeformStep) => void): Recipe =>
  produce(recipe, (draft) => {
    const step = draft.steps.find((each) => each.id === id);
    if (step?.type === 'deform') change(step);
  });
