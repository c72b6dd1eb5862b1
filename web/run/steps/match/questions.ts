// What may be asked of a match beside its skins: where a place of one model belongs on another, before there are any.

import type { MatchStep } from '../../../recipe/steps/match';
import { isWhole } from '../../../recipe/steps/match';
import { type StepContext, signalOf } from '../step-runner';
import { placePoints } from './places';

interface Asked {
  /** Numbers of two of the step's models. */
  readonly from: number;
  readonly to: number;
  /** Of the first, 3 numbers. */
  readonly place: Float64Array;
}

interface Carried {
  /** The skins of two models, and their triangles. */
  readonly from: Float64Array;
  readonly to: Float64Array;
  readonly triangles: Uint32Array;
  /** Near the first, 3 numbers each. */
  readonly places: Float64Array;
}

export const matchQuestions = {
  /** Laid on the other model by the markers that both have; without any by how the two lie. */
  guessPlace(step: MatchStep, context: StepContext, { from, to, place }: Asked): Promise<Float64Array> {
    const [first, second] = [context.inputs[from]!, context.inputs[to]!];
    const both = step.markers.filter((marker) => isWhole([marker[from] ?? null, marker[to] ?? null]));
    const placed = (at: number) =>
      placePoints(
        context.inputs[at]!.model,
        both.map((marker) => marker[at]!),
        step.models[at]!,
      );
    return context.kernel.call(
      'guessPlace',
      {
        from: first.opened.id,
        to: second.opened.id,
        fromMarkers: placed(from),
        toMarkers: placed(to),
        place,
      },
      signalOf(context),
    );
  },

  /** Of one of the step's models: what an angle keeps, as rows of vertices. */
  sharpEdges: (
    _step: MatchStep,
    context: StepContext,
    { model, angle }: { readonly model: number; readonly angle: number },
  ): Promise<readonly Uint32Array[]> =>
    context.kernel.call('sharpEdges', { model: context.inputs[model]!.opened.id, angle }, signalOf(context)),

  /** By skins that were made before. */
  carryPlaces: (_step: MatchStep, context: StepContext, skins: Carried): Promise<Float64Array> =>
    context.kernel.call('carryPlaces', skins, signalOf(context)),
};
