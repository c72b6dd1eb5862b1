// What the isoline method takes of memory: asked before anything is set up, said while it is, refused where it is too much.

import { LissomError } from '../../../core/errors';
import { hashValue } from '../../../core/hash';
import { vertexCount } from '../../../core/model';
import { inBytes } from '../../../core/sizes';
import type { IsolineOptions } from '../../../kernel/contract/isoline';
import type { DeformStep } from '../../../recipe/steps/deform';
import { type Preparation, type StepContext, signalOf } from '../step-runner';
import { held } from './handles';

const TOO_LARGE = 'isolines-too-large';
/** As far as it has been measured. */
const MOST_VERTICES = 2_000_000;
/** All that WebAssembly can address. */
const MOST_BYTES = 4 * 2 ** 30;

/**
 * Asks the kernel, once for each number of handles.
 *
 * @param settled  whether a full pass is to follow
 * @throws LissomError `isolines-too-large`, before anything is allocated for it
 */
export async function sizeOfIsolines(
  step: DeformStep,
  options: IsolineOptions,
  settled: boolean,
  context: StepContext,
): Promise<Preparation> {
  const input = context.inputs[0]!;
  const vertices = vertexCount(input.model);
  if (vertices > MOST_VERTICES) throw tooLarge(vertices);
  // What the region leaves out is held as one more.
  const handles = held(step).length + (step.roi === 'all' ? 0 : 1);
  const memory = await context.kernel.hold(
    'estimateIsolines',
    hashValue({ model: input.key, handles, options }),
    { model: input.opened.id, handles, options },
    signalOf(context),
  );
  const bytes = Math.max(memory.model, memory.session + (settled ? memory.settle : 0));
  if (bytes > MOST_BYTES) throw tooMuch({ vertices, bytes }, handles);
  return { vertices, bytes };
}

export const isTooLarge = (error: unknown): boolean =>
  error instanceof LissomError && error.code === TOO_LARGE;

const counted = (n: number): string => n.toLocaleString('en-US');

const tooLarge = (vertices: number): LissomError =>
  new LissomError(
    TOO_LARGE,
    `The model has ${counted(vertices)} vertices; the isoline method takes up to ${counted(MOST_VERTICES)}. ` +
      'Choose another method, or simplify the model first.',
  );

const tooMuch = ({ vertices, bytes }: Preparation, handles: number): LissomError =>
  new LissomError(
    TOO_LARGE,
    `The isoline method would take about ${inBytes(bytes)} for ${counted(vertices)} vertices and ${counted(handles)} ` +
      `handles; there are ${inBytes(MOST_BYTES)} at most. Choose fewer controls or fewer handles, or another method.`,
  );
