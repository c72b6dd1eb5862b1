// The isoline method of a deform step (001): a surface once per mesh, a few controls per set of handles.

import { hashValue } from '../../../core/hash';
import { vertexCount, withPositions } from '../../../core/model';
import { toIndices } from '../../../core/vertex-set';
import type {
  IsolineFields,
  IsolineFrame,
  IsolineOptions,
  PreparedIsolines,
} from '../../../kernel/contract/isoline';
import type { DeformStep } from '../../../recipe/steps/deform';
import { vertexSetKey } from '../../vertex-sets';
import { type StepContext, type StepOutcome, signalOf } from '../step-runner';
import { handlesKey, held, specsOf, targetsOf } from './handles';
import { isTooLarge, sizeOfIsolines } from './isoline-size';

export interface IsolineFigures {
  readonly unknowns: number;
  readonly iterations: number;
  /** Placed where flat isolines leave no rotation. */
  readonly freeHandles: number;
  /** Whether the result has had a full pass. */
  readonly settled: boolean;
}

/** Shares of the work before the last part. */
const SURFACE = 0.5;
const FIELDS = 0.8;

/** @param step  with at least one handle that holds something */
export async function runIsolines(
  step: DeformStep,
  context: StepContext,
): Promise<StepOutcome<IsolineFigures>> {
  const input = context.inputs[0]!;
  const full = context.settle && step.options.settle !== 'reduced';
  const { surface, prepared } = await prepareIsolines(step, context, full);
  const posed = await context.kernel.call(
    'poseIsolines',
    { isolines: prepared.id, targets: targetsOf(held(step), input.model.positions), settle: full },
    { ...signalOf(context), onProgress: (fraction) => context.onProgress(FIELDS + (1 - FIELDS) * fraction) },
  );
  return {
    model: withPositions(input.model, posed.positions),
    figures: {
      unknowns: prepared.unknowns,
      iterations: posed.iterations,
      freeHandles: prepared.freeHandles,
      settled: full && prepared.settlesFully,
    },
    seconds: { ...surface.seconds, ...prepared.seconds, ...posed.seconds },
    peakBytes: Math.max(surface.peakBytes, prepared.peakBytes),
    warnings: [...prepared.warnings, ...posed.warnings],
  };
}

/** A frame of a drag: what the graphics card blends by. */
export interface IsolineDrag extends IsolineFrame {
  readonly prepared: PreparedIsolines;
}

/**
 * One frame of a drag, from where the last one ended. `null` where nothing is held, and where the model is too large for
 * the method but has another to be moved by.
 */
export async function dragIsolines(step: DeformStep, context: StepContext): Promise<IsolineDrag | null> {
  const handles = held(step);
  if (handles.length === 0) return null;
  const ready = await prepareIsolines(step, context).catch((error: unknown) => {
    if (step.method !== 'isolines' && isTooLarge(error)) return null;
    throw error;
  });
  if (!ready) return null;
  const { prepared } = ready;
  const targets = targetsOf(handles, context.inputs[0]!.model.positions);
  const frame = await context.kernel.call(
    'dragIsolines',
    { isolines: prepared.id, targets },
    signalOf(context),
  );
  return { ...frame, prepared };
}

/** What the graphics card needs once per set of handles. */
export async function fieldsOfIsolines(step: DeformStep, context: StepContext): Promise<IsolineFields> {
  const { prepared } = await prepareIsolines(step, context);
  return context.kernel.call('isolineFields', { isolines: prepared.id }, signalOf(context));
}

/** To show: a handle's harmonic field, or how fast the fields change, per source vertex; `null` where nothing is held. */
export async function fieldOfHandle(
  step: DeformStep,
  context: StepContext,
  { handle, what }: { readonly handle: number; readonly what: 'field' | 'rigidity' },
): Promise<Float32Array | null> {
  // Those that hold nothing have no field: numbers are those of the others.
  const handles = held(step);
  const of = step.handles[handle];
  const at = of ? handles.indexOf(of) : -1;
  if (handles.length === 0) return null;
  const { prepared } = await prepareIsolines(step, context);
  const number = what === 'rigidity' ? -1 : Math.max(0, at);
  const args = { isolines: prepared.id, handle: number, what };
  return (await context.kernel.call('isolineField', args, signalOf(context))).values;
}

/** @param settled  whether a full pass is to follow */
async function prepareIsolines(step: DeformStep, context: StepContext, settled = false) {
  const input = context.inputs[0]!;
  const { kernel, onProgress, onPreparation } = context;
  const options = optionsOf(step);
  const size = await sizeOfIsolines(step, options, settled, context);
  const surface = await kernel.hold(
    'prepareIsolineModel',
    input.key,
    () => {
      onPreparation(size);
      return { model: input.opened.id };
    },
    { ...signalOf(context), onProgress: (fraction) => onProgress(SURFACE * fraction) },
  );
  const handles = held(step);
  const count = vertexCount(input.model);
  const prepared = await kernel.hold(
    'prepareIsolines',
    hashValue({
      model: input.key,
      roi: vertexSetKey(step.roi),
      handles: handlesKey(handles),
      options,
    }),
    () => {
      onPreparation(size);
      return {
        isolineModel: surface.id,
        roi: toIndices(step.roi, count),
        handles: specsOf(handles, count),
        options,
      };
    },
    { ...signalOf(context), onProgress: (fraction) => onProgress(SURFACE + (FIELDS - SURFACE) * fraction) },
  );
  return { surface, prepared };
}

/** The paper's own names in the recipe, the kernel's here. */
function optionsOf({ options }: DeformStep): IsolineOptions {
  const { isolines, basis, local, sampledTriangles, scaleDetails } = options;
  return {
    scaleDetails,
    ...(isolines !== undefined && { controls: isolines }),
    ...(basis !== undefined && { basis }),
    ...(local !== undefined && { local }),
    ...(sampledTriangles !== undefined && { sampledTriangles }),
  };
}
