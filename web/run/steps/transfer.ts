// The transfer step: fields of both models once per set of paired handles, then only the pose or its strength changes.

import { type Finding, LissomError } from '../../core/errors';
import { hashValue } from '../../core/hash';
import { vertexCount, withPositions } from '../../core/model';
import { isEmpty, toIndices, type VertexSet } from '../../core/vertex-set';
import type { DeformStep, Step } from '../../recipe/recipe';
import { mainReference } from '../../recipe/references';
import type { TransferStep } from '../../recipe/steps/transfer';
import type { ModelResult } from '../types';
import { checkApart, checkVertices, vertexSetKey } from '../vertex-sets';
import {
  type InputShape,
  type Origin,
  type StepContext,
  type StepOutcome,
  type StepRunner,
  signalOf,
} from './step-runner';
import { checkThrough, isThrough, membersOf, runThrough } from './transfer/through';

/** Between two handles a field has a slope; with one alone there is nothing to tell places apart by. */
const FEWEST_PAIRS = 2;

const UNTIMED = { fields: 0, reduce: 0, perIteration: 0, solve: 0 };

export interface TransferFigures {
  readonly unknowns: number;
  readonly iterations: number;
}

export const transferRunner = {
  /** The one on screen, and the one to switch back to. */
  keeps: { prepareTransfer: 2, prepareTransferThrough: 2 },

  check(step, path, [target, posed]) {
    if (isThrough(step)) return checkThrough(step, path, posed);
    if (posed) checkPose(step, path, posed);
    if (!target) return;
    for (const [at, set] of step.handles.entries()) checkVertices(set, `${path}.handles[${at}]`, target);
    checkApart(step.handles, `${path}.handles`, target);
  },

  vertexCount: ([target]) => target?.vertices,

  /** Of the pose its vertices tell everything, except which of the handles are which. */
  content: (step, [, pose]) => ({
    held: isPose(pose) ? pose.handles.map(({ vertices }) => vertexSetKey(vertices)) : [],
    handles: step.handles.map(vertexSetKey),
    strength: step.strength,
    keepStretch: step.keepStretch,
    through: pose && isThrough(step) && membersOf(step, pose),
  }),

  async run(step, context): Promise<StepOutcome<TransferFigures>> {
    if (isThrough(step)) return runThrough(step, context);
    const [target, posed] = context.inputs as [ModelResult, ModelResult];
    const { pose, rest } = sourceOf(context);
    const pairs = pairsOf(step, pose, vertexCount(target.model), vertexCount(rest.model));
    const unpaired = pose.handles.length - pairs.length;
    const warnings = unpaired > 0 ? [finding('unpaired-handle', unpaired)] : [];
    // Handles are paired one after the other: a document half made is no error.
    if (pairs.length < FEWEST_PAIRS)
      return unchanged(target, [...warnings, finding('few-pairs', pairs.length)]);

    const signal = signalOf(context);
    // It may be long since the pose was made.
    const source = await context.kernel.open(rest.model, context.signal, rest.key);
    const sourceHandles = pairs.map(({ source: held }) => held);
    const targetHandles = pairs.map(({ target: held }) => held);
    const prepared = await context.kernel.hold(
      'prepareTransfer',
      hashValue({
        source: source.key,
        target: target.key,
        handles: pairs.map(({ sets }) => sets.map(vertexSetKey)),
      }),
      { source: source.opened.id, sourceHandles, target: target.opened.id, targetHandles },
      { ...signal, onProgress: (fraction) => context.onProgress(0.9 * fraction) },
    );
    const { strength, keepStretch } = step;
    const transferred = await context.kernel.call(
      'transfer',
      { transfer: prepared.id, pose: posed.model.positions, strength, keepStretch },
      signal,
    );
    return {
      model: withPositions(target.model, transferred.positions),
      figures: { unknowns: prepared.unknowns, iterations: transferred.iterations },
      seconds: { ...prepared.seconds, ...transferred.seconds },
      peakBytes: prepared.peakBytes,
      warnings: [...warnings, ...prepared.warnings, ...transferred.warnings],
    };
  },
} satisfies StepRunner<TransferStep>;

const isPose = (step: Step | undefined): step is DeformStep => step?.type === 'deform';

/** @throws LissomError `not-a-pose`, `handle-count` */
function checkPose({ handles }: TransferStep, path: string, { name, maker }: InputShape): void {
  if (!isPose(maker)) {
    const what = maker ? `a step of type ${maker.type}` : 'a model';
    throw new LissomError(
      'not-a-pose',
      `${path}.like: ${JSON.stringify(name)} is ${what}; name a deform step, whose pose is to be given.`,
    );
  }
  const wanted = maker.handles.length;
  if (handles.length === wanted) return;
  throw new LissomError(
    'handle-count',
    `${path}.handles: expected ${wanted}, one vertex set for each handle of ${JSON.stringify(name)} and in their order ` +
      `(an empty one where there is no counterpart), but there are ${handles.length}.`,
  );
}

/** The step that has the pose, and the model that it poses. */
function sourceOf({ origins }: StepContext): {
  readonly pose: DeformStep;
  readonly rest: Origin['inputs'][number];
} {
  const { step, inputs } = origins[1]!;
  return { pose: step as DeformStep, rest: inputs[mainReference(step)]! };
}

interface Pair {
  /** As they are written. */
  readonly sets: readonly VertexSet[];
  readonly source: Uint32Array;
  readonly target: Uint32Array;
}

/** The handles that both models have. */
const pairsOf = (step: TransferStep, pose: DeformStep, targets: number, sources: number): Pair[] =>
  pose.handles.flatMap(({ vertices }, at) => {
    const counterpart = step.handles[at]!;
    if (isEmpty(vertices) || isEmpty(counterpart)) return [];
    const sets = [vertices, counterpart];
    return [{ sets, source: toIndices(vertices, sources), target: toIndices(counterpart, targets) }];
  });

const unchanged = ({ model }: ModelResult, warnings: readonly Finding[]): StepOutcome<TransferFigures> => ({
  model,
  figures: { unknowns: 0, iterations: 0 },
  seconds: UNTIMED,
  peakBytes: 0,
  warnings,
});

const finding = (code: string, count: number): Finding => ({ code, count, examples: [], repaired: true });
