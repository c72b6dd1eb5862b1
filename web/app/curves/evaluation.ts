// How a curves step is computed for the screen: regions and places once per rest drawing, then one posture after
// another. While the hand moves, the graphics card poses the model.

import { LastMade } from '../../core/last-made';
import type { PreparedCurves } from '../../kernel/contract/curve';
import type { CurvesStep } from '../../recipe/recipe';
import { mainInput } from '../../recipe/references';
import { CurveMotion } from '../../view/curves/curve-motion';
import type { Evaluating, Outcome, Request, Strategy } from '../evaluated';
import { sameBefore, untouched } from '../strategy';
import type { CurvesState } from './state';

type CurvesRequest = Request<CurvesStep>;
/** By the curves' preparation: a drag asks for their attributes once. */
type Motions = LastMade<PreparedCurves, CurveMotion>;

type Own = Pick<CurvesState, 'movable'> & { readonly contours: Pick<CurvesState['contours'], 'on'> };

export function curvesStrategy(own: Own): Strategy<CurvesStep> {
  const motions: Motions = new LastMade();
  return {
    busy: 'busy.curves',

    /** Both need the same regions: only the postures differ. */
    worthWaiting: (last, next) => atRestAlike(last.step, next.step) && sameBefore(last, next),

    async run(request, evaluating) {
      const { step, live } = request;
      if (step.curves.length === 0) return untouched(request, evaluating);
      // The thesis's planes are no table of motions, and lines of the drawing lie on vertices that are known.
      const byCard = own.movable.peek() && !own.contours.on.peek() && step.options.encoding === 'kernel';
      if (live && byCard) {
        const moved = await dragged(request, evaluating, motions);
        if (moved) return moved;
      }
      return posed(request, evaluating);
    },
  };
}

/** The input with other positions: it stays the model on screen, so that a drag moves vertices and nothing else. */
async function posed(
  { recipe, step }: CurvesRequest,
  { runner, signal, onProgress, settle }: Evaluating,
): Promise<Outcome> {
  const results = await runner.run(recipe, { signal, onProgress, until: step.id, settle });
  const { inputs, model, report } = results.get(step.id)!;
  return { inputs, shown: inputs[0]!, positions: model.positions, report };
}

/** Only a table is computed; the vertices stay where they are until the hand lets go. `null` before a first result. */
async function dragged(
  { recipe, step }: CurvesRequest,
  { runner, signal, onProgress, before }: Evaluating,
  motions: Motions,
): Promise<Outcome | null> {
  const shown = await runner.opened(recipe, mainInput(step), { signal });
  if (before?.step.id !== step.id || before.shown.key !== shown.key || !before.report) return null;
  const { prepared, texels } = await runner.ask(recipe, step.id, 'curveTable', {}, { signal, onProgress });
  const motion = await motions.of(prepared, async () => {
    const attributes = await runner.ask(recipe, step.id, 'curveAttributes', {}, { signal });
    return new CurveMotion(attributes, shown.model.positions);
  });
  const { positions, report } = before;
  return { inputs: [shown], shown, positions, moved: { motion, table: texels }, report, settled: false };
}

const AT_REST = ['kind', 'rest', 'rigid', 'region', 'anchor', 'reach', 'held'] as const;
const atRestAlike = (a: CurvesStep, b: CurvesStep): boolean =>
  a.id === b.id &&
  a.model === b.model &&
  a.links === b.links &&
  a.options === b.options &&
  a.curves.length === b.curves.length &&
  a.curves.every((curve, i) => {
    const other = b.curves[i]!;
    return AT_REST.every((field) => curve[field] === other[field]);
  });
