// The deform step: factors once per set of handles, then only the targets change.

import type { Finding } from '../../core/errors';
import { hashValue } from '../../core/hash';
import { vertexCount, withPositions } from '../../core/model';
import { toIndices } from '../../core/vertex-set';
import type { DeformHandle, DeformStep } from '../../recipe/steps/deform';
import { checkApart, checkVertices, vertexSetKey } from '../vertex-sets';
import { handlesKey, held, specsOf, targetsOf } from './deform/handles';
import {
  dragIsolines,
  fieldOfHandle,
  fieldsOfIsolines,
  type IsolineFigures,
  runIsolines,
} from './deform/isolines';
import { type StepContext, type StepOutcome, type StepRunner, signalOf } from './step-runner';

const UNTIMED = { assemble: 0, factor: 0, solve: 0, rotate: 0, reconstruct: 0 };

export interface DeformFigures extends Partial<IsolineFigures> {
  /** Vertices that were solved for; the isoline method solves for none. */
  readonly free?: number;
  readonly degenerate?: number;
  readonly iterations: number;
}

export const deformRunner = {
  /** The one being dragged, and the ones to switch back to. */
  keeps: { prepareDeform: 3, estimateIsolines: 3, prepareIsolineModel: 2, prepareIsolines: 3 },

  check(step, path, [input]) {
    if (!input) return;
    checkVertices(step.roi, `${path}.roi`, input);
    for (const [at, handle] of step.handles.entries())
      checkVertices(handle.vertices, `${path}.handles[${at}].vertices`, input);
    checkApart(
      step.handles.map(({ vertices }) => vertices),
      `${path}.handles`,
      input,
    );
  },

  vertexCount: ([input]) => input?.vertices,

  content: (step) => ({ ...constraints(step), targets: step.handles.map(target) }),

  async run(step, context): Promise<StepOutcome<DeformFigures>> {
    const input = context.inputs[0]!;
    const handles = held(step);
    const unheld = step.handles.length - handles.length;
    const warnings: Finding[] = unheld > 0 ? [finding('empty-handle', unheld)] : [];
    // A step that nothing holds yet leaves its input as it is: a document half made is no error.
    if (handles.length === 0) return unchanged(context, [...warnings, finding('no-handle', 1)]);

    const { method } = step;
    if (method === 'isolines') {
      const outcome = await runIsolines(step, context);
      return { ...outcome, warnings: [...warnings, ...outcome.warnings] };
    }
    const count = vertexCount(input.model);
    const prepared = await context.kernel.hold(
      'prepareDeform',
      hashValue({ model: input.key, ...constraints(step) }),
      () => ({
        model: input.opened.id,
        roi: toIndices(step.roi, count),
        handles: specsOf(handles, count),
        options: { method, ...implicitOptions(step) },
      }),
      { ...signalOf(context), onProgress: (fraction) => context.onProgress(0.9 * fraction) },
    );
    const deformed = await context.kernel.call(
      'deform',
      { deform: prepared.id, targets: targetsOf(handles, input.model.positions), settle: context.settle },
      signalOf(context),
    );
    return {
      model: withPositions(input.model, deformed.positions),
      figures: { free: prepared.free, degenerate: prepared.degenerate, iterations: deformed.iterations },
      seconds: { ...prepared.seconds, ...deformed.seconds },
      peakBytes: prepared.peakBytes,
      warnings: [...warnings, ...prepared.warnings, ...deformed.warnings],
    };
  },
  questions: {
    /** A frame of a drag by the isoline method, whatever the step's own is; `null` where nothing is held. */
    drag: dragIsolines,
    /** What the graphics card needs for such frames. */
    dragFields: fieldsOfIsolines,
    /** A handle's field, to show. */
    handleField: fieldOfHandle,
  },
} satisfies StepRunner<DeformStep>;

const implicitOptions = ({ options }: DeformStep) => {
  const { removeShear, scaleDetails, iterations, coherenceRing } = options;
  return { removeShear, scaleDetails, iterations, coherenceRing };
};

/** What is factored: everything but where the handles go. Names and hiding are for the eye only. */
const constraints = (step: DeformStep): object => ({
  roi: vertexSetKey(step.roi),
  handles: handlesKey(held(step)),
  method: step.method,
  options: step.options,
});

const target = (handle: DeformHandle): readonly number[] =>
  handle.kind === 'region' ? handle.matrix : handle.position;

const unchanged = ({ inputs }: StepContext, warnings: readonly Finding[]): StepOutcome<DeformFigures> => ({
  model: inputs[0]!.model,
  figures: { free: 0, degenerate: 0, iterations: 0 },
  seconds: UNTIMED,
  peakBytes: 0,
  warnings,
});

const finding = (code: string, count: number): Finding => ({ code, count, examples: [], repaired: true });
