// A merge step from a recipe: its two models at once, the merged one when it is asked for and can be had.

import { isCancelled, LissomError } from '../../core/errors';
import type { MergeStep, Recipe } from '../../recipe/recipe';
import type { RunOptions } from '../../run/evaluate';
import type { StepReport } from '../../run/results';
import type { ModelResult } from '../../run/types';
import type { Evaluation, RunnerPort } from '../evaluation';
import { tCode } from '../i18n';
import type { State } from '../state';
import type { MergeFigures } from './state';
import { isReady, withMergeStep } from './steps';

export interface MergedStep {
  readonly input: ModelResult;
  readonly positions: Float64Array;
  readonly strands: null;
  readonly report: StepReport | null;
}

/** How the open merge step is wanted: not yet, along the region's edge, or as it is. Reads signals. */
export function mergeWanted(state: State, step: MergeStep): 'held' | 'before' | 'whole' {
  const { held, before } = state.merge;
  if (held.value === step.id) return 'held';
  return before.value && step.optimalBoundary ? 'before' : 'whole';
}

/** The merged model takes the place of the input, for it is a model of its own; until there is one, the target does. */
export async function runMerge(
  runner: RunnerPort,
  recipe: Recipe,
  step: MergeStep,
  wanted: ReturnType<typeof mergeWanted>,
  { merge }: Pick<State, 'merge'>,
  options: RunOptions,
): Promise<MergedStep> {
  const { signal } = options;
  const aborting = signal ? { signal } : {};
  const source = await runner.opened(recipe, step.source, aborting);
  const target = await runner.opened(recipe, step.target, aborting);
  if (!signal?.aborted)
    merge.opened.value = {
      source: { name: step.source, result: source },
      target: { name: step.target, result: target },
    };
  const bare = { input: target, positions: target.model.positions, strands: null, report: null };
  if (!isReady(step) || wanted === 'held') {
    merge.problem.value = null;
    return bare;
  }
  const asked = wanted === 'before' ? withMergeStep(recipe, withoutRounds(step)) : recipe;
  try {
    const results = await runner.run(asked, { ...options, until: step.id });
    const input = await runner.opened(asked, step.id, aborting);
    if (!signal?.aborted) merge.problem.value = null;
    const { report } = results.get(step.id)!;
    return { input, positions: input.model.positions, strands: null, report };
  } catch (error) {
    if (!(error instanceof LissomError) || isCancelled(error) || error.fault !== 'input') throw error;
    if (!signal?.aborted)
      merge.problem.value = tCode('merge.problem.', error.code, 'error.unknown', { detail: error.message });
    return bare;
  }
}

const withoutRounds = (step: MergeStep): MergeStep =>
  step.optimalBoundary ? { ...step, optimalBoundary: { ...step.optimalBoundary, rounds: 0 } } : step;

export function mergeFigures({ report, input }: Evaluation): MergeFigures | null {
  if (report?.type !== 'merge') return null;
  const { seamVertices, eulerCharacteristic, seam, energy = [], keys = [] } = report;
  return {
    seamVertices,
    closed: input.opened.closed,
    eulerCharacteristic,
    seamDihedral: seam.highDihedral,
    ownDihedral: seam.ownHighDihedral,
    energy,
    keys,
  };
}
