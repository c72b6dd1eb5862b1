// Hair from a recipe: what has to be grown anew and what has not.

import type { Strands } from '../../core/strands';
import type { HairStep, Recipe } from '../../recipe/recipe';
import type { RunOptions } from '../../run/evaluate';
import type { StepReport } from '../../run/results';
import { scalpOf } from '../../run/steps/hair/scalp';
import type { ModelResult } from '../../run/types';
import type { RunnerPort } from '../evaluation';

export interface GrownStep {
  readonly input: ModelResult;
  readonly positions: Float64Array;
  readonly strands: Strands | null;
  readonly report: StepReport | null;
}

/** Runs a hair step. A head whose scalp is still to be painted is only opened. */
export async function runHair(
  runner: RunnerPort,
  recipe: Recipe,
  step: HairStep,
  options: RunOptions,
): Promise<GrownStep> {
  const { signal } = options;
  const input = await runner.opened(recipe, step.model, signal ? { signal } : {});
  const { positions } = input.model;
  if (scalpOf(step, input.model).length === 0) return { input, positions, strands: null, report: null };
  const results = await runner.run(recipe, { ...options, until: step.id });
  const { report, strands = null } = results.get(step.id)!;
  return { input, positions, strands, report };
}

/** Whether two states of a step grow the same strands, field for field: only look, names and the like differ. */
export function growsAlike(a: HairStep, b: HairStep): boolean {
  return (
    a.id === b.id &&
    a.model === b.model &&
    a.scalp === b.scalp &&
    a.grid === b.grid &&
    a.streams === b.streams &&
    a.partings === b.partings &&
    a.ponytails === b.ponytails &&
    a.strands === b.strands &&
    a.length === b.length &&
    a.volume === b.volume &&
    a.detail === b.detail
  );
}

/** Whether both are of one head: the field is prepared for it once. */
export const sameHead = (a: HairStep, b: HairStep): boolean =>
  a.id === b.id && a.model === b.model && a.scalp === b.scalp && a.grid.resolution === b.grid.resolution;
