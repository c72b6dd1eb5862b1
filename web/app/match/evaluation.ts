// How a match is computed for the screen: its models at once, the skins when they are asked for. What was matched before
// stays on screen until then.

import { isCancelled, LissomError } from '../../core/errors';
import type { MatchStep } from '../../recipe/recipe';
import { isWhole } from '../../recipe/steps/match';
import type { StepReport } from '../../run/results';
import type { ModelResult } from '../../run/types';
import type { Evaluating, Evaluation, Outcome, Request, Strategy } from '../evaluated';
import { problemText } from '../problem-text';
import { atRest, sameBefore } from '../strategy';
import { type Matching, matchingOf } from './result';
import { growingSkins, type MatchState } from './state';

/** With one or two it is open how the models are turned. */
export const FEWEST_MARKERS = 3;

/** What each report was of. */
const matchings = new WeakMap<StepReport, Matching>();

export const matchStrategy = (own: MatchState): Strategy<MatchStep> => ({
  busy: 'busy.matching',

  /** On opening a document: where enough is marked. Later: when the button is pressed. */
  wish: (step) => (own.isAsked(step) || (!own.isHeld(step) && isMarked(step)) ? 'match' : 'held'),

  /** A match under way is not given up for marks that are to be matched later. */
  worthWaiting: (last, next) =>
    (next.wish === 'held' || last.step === next.step) &&
    last.step.id === next.step.id &&
    last.step.models === next.step.models &&
    sameBefore(last, next),

  run: (request, evaluating) => matched(request, evaluating, own),

  /** What was stopped by hand waits for its button. */
  stopped(step) {
    own.hold(step.id);
    own.withdraw(step);
  },
});

async function matched(
  { recipe, step, wish }: Request<MatchStep>,
  { runner, signal, onProgress, before, show }: Evaluating,
  own: MatchState,
): Promise<Outcome> {
  const inputs: ModelResult[] = [];
  for (const name of step.models) inputs.push(await runner.opened(recipe, name, { signal }));
  const bare = atRest(inputs, 0);
  if (wish === 'held') return bare;
  // Models that are not on screen yet are seen at once.
  if (before?.inputs.some((input, i) => input !== inputs[i]) ?? true) show(bare);
  const onLook: NonNullable<Parameters<typeof runner.run>[1]>['onLook'] = (look, { id }) => {
    if (!signal.aborted && id === step.id) own.growing.value = growingSkins(look);
  };
  own.running.value = true;
  try {
    const results = await runner.run(recipe, { signal, onProgress, onLook, until: step.id });
    const result = results.get(step.id)!;
    const matching = matchingOf(step, result);
    if (matching) matchings.set(result.report, matching);
    return { ...bare, report: result.report };
  } catch (error) {
    if (!(error instanceof LissomError) || isCancelled(error) || error.fault !== 'input') throw error;
    return { ...bare, problem: error };
  } finally {
    own.running.value = false;
    own.growing.value = null;
  }
}

/** Lets the workspace follow a result. */
export function publishMatch(own: MatchState, evaluation: Evaluation | null): void {
  own.problem.value = problemText(evaluation, 'match.problem.');
  const matching = evaluation?.report && matchings.get(evaluation.report);
  if (matching) own.result.value = matching;
  else if (!evaluation || !isOf(own.result.peek(), evaluation)) own.result.value = null;
}

/** Whether skins are those of the models that are shown now. */
function isOf(result: Matching | null, { step }: Evaluation): boolean {
  if (!result || step.type !== 'match' || result.of.id !== step.id) return false;
  return (
    result.of.models.length === step.models.length &&
    result.of.models.every((name, at) => name === step.models[at])
  );
}

const isMarked = ({ markers }: MatchStep): boolean => markers.filter(isWhole).length >= FEWEST_MARKERS;

/** Markers that are set on every model: none at all will do, or three. */
export function lacking({ markers }: Pick<MatchStep, 'markers'>): number {
  const { length } = markers.filter(isWhole);
  return markers.length === 0 ? 0 : Math.max(0, FEWEST_MARKERS - length);
}
