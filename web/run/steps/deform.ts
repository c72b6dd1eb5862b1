// The deform step: factors once per set of handles, then only the targets change.

import { type Finding, LissomError } from '../../core/errors';
import { hashValue } from '../../core/hash';
import { vertexCount, withPositions } from '../../core/model';
import { isEmpty, toIndices } from '../../core/vertex-set';
import type { DeformHandle, DeformStep } from '../../recipe/steps/deform';
import { checkApart, checkVertices, vertexSetKey } from '../vertex-sets';
import type { StepContext, StepOutcome, StepRunner } from './step-runner';

const UNTIMED = { assemble: 0, factor: 0, solve: 0, rotate: 0, reconstruct: 0 };

export interface DeformFigures {
  readonly free: number;
  readonly degenerate: number;
  readonly iterations: number;
}

export const deformRunner = {
  /** The one being dragged, and the ones to switch back to. */
  keeps: { prepareDeform: 3 },

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

    const count = vertexCount(input.model);
    const prepared = await context.kernel.hold(
      'prepareDeform',
      hashValue({ model: input.key, ...constraints(step) }),
      {
        model: input.opened.id,
        roi: toIndices(step.roi, count),
        handles: handles.map(({ kind, vertices }) => ({
          kind,
          vertices: toIndices(vertices, count),
        })),
        options: { method: step.method, ...step.options },
      },
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
} satisfies StepRunner<DeformStep>;

/** Handles with vertices; one painted and wholly erased again holds nothing. */
const held = (step: DeformStep): DeformHandle[] => step.handles.filter(({ vertices }) => !isEmpty(vertices));

/** What is factored: everything but where the handles go. Names and hiding are for the eye only. */
const constraints = (step: DeformStep): object => ({
  roi: vertexSetKey(step.roi),
  handles: held(step).map(({ kind, vertices }) => [kind, vertexSetKey(vertices)]),
  method: step.method,
  options: step.options,
});

const target = (handle: DeformHandle): readonly number[] =>
  handle.kind === 'region' ? handle.matrix : handle.position;

/** One column-major 4×4 per handle, end to end; a point handle becomes the translation that places its vertex. */
function targetsOf(handles: readonly DeformHandle[], rest: Float64Array): Float64Array {
  const targets = new Float64Array(16 * handles.length);
  for (const [at, handle] of handles.entries()) {
    if (handle.kind === 'region') targets.set(handle.matrix, 16 * at);
    else targets.set(translation(handle.vertices[0]!, handle.position, rest), 16 * at);
  }
  return targets;
}

function translation(vertex: number, position: readonly number[], rest: Float64Array): number[] {
  const by = position.map((coordinate, axis) => coordinate - rest[3 * vertex + axis]!);
  if (!by.every(Number.isFinite))
    throw new LissomError(
      'vertex-not-finite',
      `The point handle's vertex ${vertex} has no finite position in the model; choose another vertex.`,
    );
  return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...by, 1];
}

const unchanged = ({ inputs }: StepContext, warnings: readonly Finding[]): StepOutcome<DeformFigures> => ({
  model: inputs[0]!.model,
  figures: { free: 0, degenerate: 0, iterations: 0 },
  seconds: UNTIMED,
  peakBytes: 0,
  warnings,
});

const finding = (code: string, count: number): Finding => ({ code, count, examples: [], repaired: true });

const signalOf = ({ signal }: StepContext) => (signal ? { signal } : {});
