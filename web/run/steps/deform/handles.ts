// What the kernel is told of a step's handles.

import { LissomError } from '../../../core/errors';
import { isEmpty, toIndices } from '../../../core/vertex-set';
import type { HandleSpec } from '../../../kernel/contract/model';
import type { DeformHandle, DeformStep } from '../../../recipe/steps/deform';
import { vertexSetKey } from '../../vertex-sets';

/** Handles with vertices; one painted and wholly erased again holds nothing. */
export const held = (step: DeformStep): DeformHandle[] =>
  step.handles.filter(({ vertices }) => !isEmpty(vertices));

/** What they hold, for keys. */
export const handlesKey = (handles: readonly DeformHandle[]) =>
  handles.map(({ kind, vertices }) => [kind, vertexSetKey(vertices)]);

/** @param count  of vertices of the model they hold */
export const specsOf = (handles: readonly DeformHandle[], count: number): HandleSpec[] =>
  handles.map(({ kind, vertices }) => ({ kind, vertices: toIndices(vertices, count) }));

/** One column-major 4×4 per handle, end to end; a point handle becomes the translation that places its vertex. */
export function targetsOf(handles: readonly DeformHandle[], rest: Float64Array): Float64Array {
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
