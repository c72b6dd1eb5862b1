// How a deform step is computed for the screen: factored once per set of handles, solved as often as they move.

import type { DeformStep } from '../../recipe/recipe';
import type { Evaluating, Outcome, Request, Strategy } from '../evaluated';
import { sameBefore, untouched } from '../strategy';

export const deformStrategy: Strategy<DeformStep> = {
  busy: 'busy.preparing',

  /** Both need the same factorization: only where the handles go differs. */
  worthWaiting(last, next) {
    const [a, b] = [last.step, next.step];
    return (
      a.id === b.id &&
      a.model === b.model &&
      a.roi === b.roi &&
      a.method === b.method &&
      a.options === b.options &&
      a.handles.length === b.handles.length &&
      a.handles.every((handle, i) => handle.vertices === b.handles[i]!.vertices) &&
      sameBefore(last, next)
    );
  },

  run(request, evaluating) {
    return request.step.handles.length === 0 ? untouched(request, evaluating) : deformed(request, evaluating);
  },
};

/** The input with other positions: it stays the model on screen, so that a drag moves vertices and nothing else. */
async function deformed(
  { recipe, step }: Request,
  { runner, signal, onProgress, settle }: Evaluating,
): Promise<Outcome> {
  const results = await runner.run(recipe, { signal, onProgress, until: step.id, settle });
  const { inputs, model, report } = results.get(step.id)!;
  return { inputs, shown: inputs[0]!, positions: model.positions, report };
}
