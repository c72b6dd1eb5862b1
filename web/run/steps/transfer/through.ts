// A pose given through a match: from skin to skin, so that nothing need be paired.

import { LissomError } from '../../../core/errors';
import { hashValue } from '../../../core/hash';
import { withPositions } from '../../../core/model';
import type { Step } from '../../../recipe/recipe';
import { mainInput, mainReference } from '../../../recipe/references';
import { memberOf, type TransferStep } from '../../../recipe/steps/transfer';
import type { ModelResult } from '../../types';
import { type InputShape, type StepContext, type StepOutcome, signalOf } from '../step-runner';

export type ThroughStep = TransferStep & { readonly through: string };

export const isThrough = (step: TransferStep): step is ThroughStep => step.through !== undefined;

/** Steps that move the vertices of a model and no more. */
const POSES: readonly (string | undefined)[] = ['deform', 'curves'] satisfies Step['type'][];

/** @throws LissomError `handle-count`, `not-a-pose` */
export function checkThrough({ handles }: ThroughStep, path: string, posed: InputShape | undefined): void {
  if (handles.length > 0)
    throw new LissomError(
      'handle-count',
      `${path}.handles: a pose that goes through a match needs no counterparts; leave them out, or leave out "through".`,
    );
  if (!posed || POSES.includes(posed.maker?.type)) return;
  const what = posed.maker ? `a step of type ${posed.maker.type}` : 'a model';
  throw new LissomError(
    'not-a-pose',
    `${path}.like: ${JSON.stringify(posed.name)} is ${what}; name a deform or curves step, whose pose is to be given.`,
  );
}

/** The two models, as the match calls them. */
export const membersOf = ({ through, model }: ThroughStep, pose: Step) => ({
  from: memberOf(through, mainInput(pose)),
  to: memberOf(through, model),
});

export async function runThrough(step: ThroughStep, context: StepContext): Promise<StepOutcome<Figures>> {
  const [target, posed, skin] = context.inputs as [ModelResult, ModelResult, ModelResult];
  const { step: pose, inputs } = context.origins[1]!;
  const skins = context.origins[2]!.models!;
  const { from, to } = membersOf(step, pose);
  const rest = inputs[mainReference(pose)]!;
  // It may be long since the pose was made.
  const source = await context.kernel.open(rest.model, context.signal, rest.key);
  const prepared = await context.kernel.hold(
    'prepareTransferThrough',
    hashValue({ source: source.key, target: target.key, skins: skin.key, from, to }),
    {
      source: source.opened.id,
      target: target.opened.id,
      triangles: skin.model.faceVertices,
      from: skins[from]!.positions,
      to: skins[to]!.positions,
    },
    { ...signalOf(context), onProgress: (fraction) => context.onProgress(0.9 * fraction) },
  );
  const { strength, keepStretch } = step;
  const transferred = await context.kernel.call(
    'transferThrough',
    { transfer: prepared.id, pose: posed.model.positions, strength, keepStretch },
    signalOf(context),
  );
  return {
    model: withPositions(target.model, transferred.positions),
    figures: { unknowns: prepared.unknowns, iterations: transferred.iterations },
    seconds: { ...prepared.seconds, ...transferred.seconds },
    peakBytes: prepared.peakBytes,
    warnings: [],
  };
}

interface Figures {
  readonly unknowns: number;
  readonly iterations: number;
}
