import type { Step, StepType } from '../../recipe/recipe';
import { deformRunner } from './deform';
import { hairRunner } from './hair';
import { mergeRunner } from './merge';
import type { StepRunner } from './step-runner';

/** One line per step type: the registry of this floor. */
const runners: { readonly [T in StepType]: StepRunner<Extract<Step, { type: T }>> } = {
  deform: deformRunner,
  merge: mergeRunner,
  hair: hairRunner,
};

export const runnerOf = (step: Step): StepRunner<Step> => runners[step.type];
