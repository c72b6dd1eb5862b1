// How a curves step is computed for the screen: regions and places once per rest drawing, then one posture after another.

import type { CurvesStep } from '../../recipe/recipe';
import type { Strategy } from '../evaluated';
import { sameBefore, untouched } from '../strategy';

export const curvesStrategy: Strategy<CurvesStep> = {
  busy: 'busy.curves',

  /** Both need the same regions: only the postures differ. */
  worthWaiting: (last, next) => atRestAlike(last.step, next.step) && sameBefore(last, next),

  /** The input with other positions: it stays the model on screen, so that a drag moves vertices and nothing else. */
  async run(request, evaluating) {
    const { recipe, step } = request;
    if (step.curves.length === 0) return untouched(request, evaluating);
    const { runner, signal, onProgress, settle } = evaluating;
    const results = await runner.run(recipe, { signal, onProgress, until: step.id, settle });
    const { inputs, model, report } = results.get(step.id)!;
    return { inputs, shown: inputs[0]!, positions: model.positions, report };
  },
};

const atRestAlike = (a: CurvesStep, b: CurvesStep): boolean =>
  a.id === b.id &&
  a.model === b.model &&
  a.links === b.links &&
  a.options === b.options &&
  a.curves.length === b.curves.length &&
  a.curves.every((curve, i) => {
    const { rest, rigid, region, anchor } = b.curves[i]!;
    return curve.rest === rest && curve.rigid === rigid && curve.region === region && curve.anchor === anchor;
  });
