// How hair is computed for the screen: the first strands at once, all of them when the hand is still.

import type { HairStep } from '../../recipe/recipe';
import { scalpOf } from '../../run/steps/hair/scalp';
import type { Evaluating, Evaluation, Outcome, Request, Strategy } from '../evaluated';
import { atRest, sameBefore, untouched } from '../strategy';

type HairRequest = Request<HairStep>;

export const hairStrategy: Strategy<HairStep> = {
  busy: 'busy.growing',

  /** A preview of the same head is done soon, and its field is prepared for the next one. */
  worthWaiting: (last, next) => last.live && sameHead(last.step, next.step) && sameBefore(last, next),

  async run(request, evaluating) {
    const { step, live } = request;
    const { before, show } = evaluating;
    const alike = before && isAlike(before, request) ? before : null;
    // Only the look has changed: the strands are known.
    if (alike && (live || alike.settled)) return grown(request, evaluating, alike.settled);
    if (before?.step.id !== step.id) {
      // A head takes its time to be prepared; until then it is seen bare rather than not at all.
      show(await untouched(request, evaluating));
    }
    if (live || !alike) {
      const first = await grown(request, evaluating, false);
      if (live || !first.strands) return { ...first, settled: !live };
      show(first);
    }
    return grown(request, evaluating, true);
  },
};

/** @param settled  all strands; else the first of them. A head whose scalp is still to be painted is only opened. */
async function grown(request: HairRequest, evaluating: Evaluating, settled: boolean): Promise<Outcome> {
  const { recipe, step } = request;
  const { runner, signal, onProgress } = evaluating;
  const bare = await untouched(request, evaluating);
  if (scalpOf(step, bare.shown.model).length === 0) return { ...bare, settled };
  const results = await runner.run(recipe, { signal, onProgress, until: step.id, settle: settled });
  const { inputs, report, strands = null } = results.get(step.id)!;
  return { ...atRest(inputs, 0), strands, report, settled };
}

/** Whether the strands on screen are those of the request, but for their look. */
const isAlike = ({ step, recipe }: Evaluation, next: HairRequest): boolean =>
  step.type === 'hair' && growsAlike(step, next.step) && sameBefore({ ...next, recipe }, next);

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
const sameHead = (a: HairStep, b: HairStep): boolean =>
  a.id === b.id && a.model === b.model && a.scalp === b.scalp && a.grid.resolution === b.grid.resolution;
