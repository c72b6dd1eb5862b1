import type { Step, StepType } from '../../recipe/recipe';
import { deformRunner } from './deform';
import type { StepRunner } from './step-runner';

/** One line per step type: the registry of this floor. */
const runners: { readonly [T in StepType]: StepRunner<Extract<Step, { type: T }>> } = {
  deform: deformRunner,
};

export const runnerOf = (step: Step): StepRunner<Step> => runners[step.type];
