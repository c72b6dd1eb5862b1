// The lines of a view of a step's surface, and what a pull of one of them would move.

import { hashValue } from '../../../core/hash';
import { type Model, withPositions } from '../../../core/model';
import type { Args } from '../../../kernel/contract';
import type { CurvesStep } from '../../../recipe/steps/curves';
import type { ModelResult } from '../../types';
import { type StepContext, signalOf } from '../step-runner';
import { prepareCurves } from './kernel-words';

/** Influences of a vertex. */
const SLOTS = 4;

export interface ViewLinesArgs extends Omit<Args<'contourLines'>, 'contours'> {
  /** Where the vertices of the step's input are now. */
  readonly positions: Float64Array;
  /** Of smoothing the curvature. */
  readonly sweeps: number;
}

/** The curvature of a surface is worked out when it is first asked about; then a view is quick. */
export async function viewLines(
  _: CurvesStep,
  context: StepContext,
  { positions, sweeps, ...asked }: ViewLinesArgs,
) {
  const { kernel, signal, onProgress } = context;
  const [input] = context.inputs as [ModelResult];
  const { opened, key } = await kernel.open(shapedAs(input.model, positions), signal);
  const contours = await kernel.hold(
    'prepareContours',
    hashValue({ key, sweeps }),
    { model: opened.id, sweeps },
    { ...signalOf(context), onProgress },
  );
  return kernel.call('contourLines', { contours: contours.id, ...asked }, signalOf(context));
}

/** In [0, 1] per source vertex. @param curve  number of a contour of the step */
export async function pullWeights(
  step: CurvesStep,
  context: StepContext,
  { curve }: { readonly curve: number },
): Promise<Float32Array> {
  const { id } = await prepareCurves(step, context);
  const { curves, weights } = await context.kernel.call('curveAttributes', { curves: id }, signalOf(context));
  const out = new Float32Array(curves.length / SLOTS);
  for (let i = 0; i < curves.length; i++) if (curves[i] === curve) out[Math.floor(i / SLOTS)]! += weights[i]!;
  return out;
}

const shaped = new WeakMap<Float64Array, Model>();

/** The same model for the same places: its hash is worked out once. */
function shapedAs(model: Model, positions: Float64Array): Model {
  if (positions === model.positions) return model;
  const known = shaped.get(positions);
  if (known?.faceVertices === model.faceVertices) return known;
  const made = withPositions(model, positions);
  shaped.set(positions, made);
  return made;
}
