// How a deform step is computed for the screen: factored once per set of handles, solved as often as they move. A drag
// that would be slow so goes by the isolines of the handles, on the graphics card.

import { LastMade } from '../../core/last-made';
import { inBytes } from '../../core/sizes';
import type { DeformStep } from '../../recipe/recipe';
import { mainInput } from '../../recipe/references';
import type { IsolineDrag } from '../../run/steps/deform/isolines';
import type { Preparation } from '../../run/steps/step-runner';
import { IsolineMotion } from '../../view/deform/isoline-motion';
import type { Evaluating, Outcome, Request, Strategy } from '../evaluated';
import { t } from '../i18n';
import { sameBefore, untouched } from '../strategy';
import type { DeformState } from './state';

type DeformRequest = Request<DeformStep>;
/** By the handles' preparation: a drag asks for its fields once. */
type Motions = LastMade<IsolineDrag['prepared'], IsolineMotion>;

/** From so many vertices on a solve a frame cannot keep up with the hand, whatever the machine. */
const LARGE = 60_000;

export function deformStrategy(own: Pick<DeformState, 'movable'>): Strategy<DeformStep> {
  const motions: Motions = new LastMade();
  return {
    busy: 'busy.preparing',

    /** Both need the same factorization: only where the handles go differs. */
    worthWaiting: (last, next) => heldAlike(last.step, next.step) && sameBefore(last, next),

    async run(request, evaluating) {
      const { step, live } = request;
      if (step.handles.length === 0) return untouched(request, evaluating);
      if (live && own.movable.peek() && goesByIsolines(step, evaluating)) {
        const moved = await dragged(request, evaluating, motions);
        if (moved) return moved;
      }
      return deformed(request, evaluating);
    },
  };
}

/** Whether two states of a step hold the same parts in the same way: only where these go differs. */
export const heldAlike = (a: DeformStep, b: DeformStep): boolean =>
  a.id === b.id &&
  a.model === b.model &&
  a.roi === b.roi &&
  a.method === b.method &&
  a.options === b.options &&
  a.handles.length === b.handles.length &&
  a.handles.every((handle, i) => handle.vertices === b.handles[i]!.vertices);

/** The plain method is there to be seen as it is. */
const goesByIsolines = ({ method, id }: DeformStep, { settle, before }: Evaluating): boolean => {
  if (method === 'isolines') return true;
  if (method === 'naive') return false;
  const known = before?.step.id === id ? before : null;
  return !settle || (known?.positions.length ?? 0) > 3 * LARGE;
};

/** The input with other positions: it stays the model on screen, so that a drag moves vertices and nothing else. */
async function deformed(
  { recipe, step }: DeformRequest,
  { runner, signal, onProgress, say, settle }: Evaluating,
): Promise<Outcome> {
  const onPreparation = announced(say);
  const results = await runner.run(recipe, { signal, onProgress, onPreparation, until: step.id, settle });
  const { inputs, model, report } = results.get(step.id)!;
  return { inputs, shown: inputs[0]!, positions: model.positions, report };
}

/** How much is set up, and what it takes. */
const announced =
  (say: Evaluating['say']) =>
  ({ vertices, bytes }: Preparation): void =>
    say(t('busy.preparing-much', { vertices, size: inBytes(bytes) }));

/** Only a few transformations are computed; the vertices stay where they are until the hand lets go. */
async function dragged(
  { recipe, step }: DeformRequest,
  { runner, signal, onProgress, say, before }: Evaluating,
  motions: Motions,
): Promise<Outcome | null> {
  const shown = await runner.opened(recipe, mainInput(step), { signal });
  const onPreparation = announced(say);
  const drag = await runner.ask(recipe, step.id, 'drag', {}, { signal, onProgress, onPreparation });
  if (!drag) return null;
  const motion = await motions.of(drag.prepared, async () => {
    const { sets, single, basis, controls } = drag.prepared;
    const fields = await runner.ask(recipe, step.id, 'dragFields', {}, { signal });
    return new IsolineMotion({ sets, single, basis, controls, ...fields });
  });
  const known = before?.step.id === step.id && before.shown.key === shown.key ? before : null;
  return {
    inputs: [shown],
    shown,
    positions: known?.positions ?? shown.model.positions,
    moved: { motion, table: drag.offsets },
    report: known?.report ?? null,
    settled: false,
  };
}
