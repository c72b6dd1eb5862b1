// How a transfer is computed for the screen: prepared once per set of pairs, then asked as often as its strength changes.

import { isCancelled, LissomError } from '../../core/errors';
import type { TransferStep } from '../../recipe/recipe';
import { pairing } from '../../tools/transfer/edits';
import type { Evaluating, Outcome, Request, Strategy } from '../evaluated';
import { atRest, sameBefore, untouched } from '../strategy';
import { poseOf } from './poses';
import type { TransferState } from './state';

/** With one handle alone nothing tells places of the model apart. */
export const FEWEST_PAIRS = 2;

export const transferStrategy = (own: Pick<TransferState, 'atRest'>): Strategy<TransferStep> => ({
  busy: 'busy.transferring',

  wish: () => (own.atRest.value ? 'rest' : 'pose'),

  /** Both need the same fields. */
  worthWaiting: (last, next) =>
    last.wish === next.wish && samePairs(last.step, next.step) && sameBefore(last, next),

  async run(request, evaluating) {
    if (request.wish === 'rest') return untouched(request, evaluating);
    try {
      return await (isReady(request) ? posed(request, evaluating) : waiting(request, evaluating));
    } catch (error) {
      if (!(error instanceof LissomError) || isCancelled(error) || error.fault !== 'input') throw error;
      return { ...(await untouched(request, evaluating)), problem: error };
    }
  },
});

/** Whether it is for the kernel to say what comes of it, or what is wrong. */
function isReady({ recipe, step }: Request<TransferStep>): boolean {
  const pose = poseOf(recipe, step);
  return (
    pose?.handles.length !== step.handles.length || pairing(step, pose.handles).paired.length >= FEWEST_PAIRS
  );
}

/** The model with other positions: it stays the model on screen. */
async function posed(
  { recipe, step }: Request,
  { runner, signal, onProgress, settle }: Evaluating,
): Promise<Outcome> {
  const results = await runner.run(recipe, { signal, onProgress, until: step.id, settle });
  const { inputs, model, report } = results.get(step.id)!;
  return { inputs, shown: inputs[0]!, positions: model.positions, report };
}

/** While too little is paired. */
async function waiting(
  { recipe, step }: Request<TransferStep>,
  { runner, signal }: Evaluating,
): Promise<Outcome> {
  const names = [step.model, step.like];
  const inputs = [];
  for (const name of names) inputs.push(await runner.opened(recipe, name, { signal }));
  return atRest(inputs, 0);
}

const samePairs = (a: TransferStep, b: TransferStep): boolean =>
  a.id === b.id &&
  a.model === b.model &&
  a.like === b.like &&
  a.through === b.through &&
  a.handles === b.handles;
