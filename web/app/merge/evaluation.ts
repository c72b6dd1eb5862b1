// How a merge is computed for the screen: its two models at once, the merged one when it is asked for and can be had.

import { isCancelled, LissomError } from '../../core/errors';
import { replaceStep } from '../../recipe/edit';
import type { MergeStep } from '../../recipe/recipe';
import type { ReportOf } from '../../run/results';
import type { Evaluating, Evaluation, Outcome, Request, Strategy } from '../evaluated';
import { problemText } from '../problem-text';
import { atRest, computed, sameBefore } from '../strategy';
import type { MergeFigures, MergeState } from './state';
import { isReady, sameCut } from './steps';

/** Number of the target among the inputs: until there is a merged model it is on screen. */
const TARGET = 1;

export const mergeStrategy = (own: MergeState): Strategy<MergeStep> => ({
  busy: 'busy.merging',

  /** Not yet, along the region's edge, or as it is. */
  wish(step) {
    if (own.isHeld(step)) return 'held';
    return own.before.value && step.optimalBoundary ? 'before' : 'whole';
  },

  /** Both are of one factored session: only the points of loops that meet differ. */
  worthWaiting: (last, next) =>
    last.wish === next.wish && sameCut(last.step, next.step) && sameBefore(last, next),

  run: merged,

  /** What was stopped by hand waits for its button. */
  stopped: ({ id }) => own.hold(id),
});

async function merged(request: Request<MergeStep>, evaluating: Evaluating): Promise<Outcome> {
  const { recipe, step, wish } = request;
  const { runner, signal, before, show } = evaluating;
  const inputs = [
    await runner.opened(recipe, step.source, { signal }),
    await runner.opened(recipe, step.target, { signal }),
  ];
  const bare = atRest(inputs, TARGET);
  if (!isReady(step) || wish === 'held') return bare;
  // Two models that are not on screen yet are seen at once; what came of them before stays until the next is there.
  if (before?.inputs.some((input, i) => input !== inputs[i]) ?? true) show(bare);
  const asked = wish === 'before' ? replaceStep(recipe, withoutRounds(step)) : recipe;
  try {
    return await computed({ ...request, recipe: asked }, evaluating);
  } catch (error) {
    if (!(error instanceof LissomError) || isCancelled(error) || error.fault !== 'input') throw error;
    return { ...bare, problem: error };
  }
}

const withoutRounds = (step: MergeStep): MergeStep =>
  step.optimalBoundary ? { ...step, optimalBoundary: { ...step.optimalBoundary, rounds: 0 } } : step;

/** Lets the workspace follow a result. */
export function publishMerge(own: MergeState, evaluation: Evaluation | null): void {
  own.figures.value = evaluation && mergeFigures(evaluation);
  own.problem.value = problemText(evaluation, 'merge.problem.');
}

function mergeFigures(evaluation: Evaluation): MergeFigures | null {
  const report = evaluation.report as ReportOf<'merge'> | null;
  if (!report) return null;
  const { seam, energy = [], keys = [] } = report;
  return {
    seamVertices: report.seamVertices,
    closed: evaluation.shown.opened.closed,
    eulerCharacteristic: report.eulerCharacteristic,
    seamDihedral: seam.highDihedral,
    ownDihedral: seam.ownHighDihedral,
    energy,
    keys,
  };
}
