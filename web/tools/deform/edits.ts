// Pure edits of a deform step's region and handles. A vertex belongs to one handle at most.

import { fromIndices, isEmpty, toIndices } from '../../core/vertex-set';
import type { DeformHandle, DeformStep } from '../../recipe/recipe';
import type { Vec3 } from '../../view/types';
import { add, IDENTITY, isIdentity, type Mat4, multiply, pointAt, transform, translation } from '../geometry';
import { rigidFit } from '../rigid-fit';
import type { DeformEdit, DeformScene } from './host';

export const withHandle = (step: DeformStep, index: number, handle: DeformHandle): DeformStep => ({
  ...step,
  handles: step.handles.map((old, i) => (i === index ? handle : old)),
});

/** The handle that holds `vertex`, hidden ones left out; −1 if none. */
export const handleAt = (step: DeformStep, vertex: number, count: number): number =>
  step.handles.findIndex((handle) => !handle.hidden && contains(handle.vertices, vertex, count));

/** The handle moved by `delta` after whatever it does already. A point handle keeps only the place. */
export function moveHandle(handle: DeformHandle, delta: Mat4): DeformHandle {
  return handle.kind === 'point'
    ? { ...handle, position: [...transform(delta, handle.position)] }
    : { ...handle, matrix: [...multiply(delta, handle.matrix)] };
}

export const shiftHandle = (handle: DeformHandle, by: Vec3): DeformHandle =>
  handle.kind === 'point'
    ? { ...handle, position: [...add(handle.position, by)] }
    : moveHandle(handle, translation(by));

/** Whether the handle leaves its vertices where they were. */
export const atRest = (handle: DeformHandle, rest: Float64Array): boolean =>
  handle.kind === 'region'
    ? isIdentity(handle.matrix)
    : pointAt(rest, handle.vertices[0]!).every((x, k) => x === handle.position[k]);

export const toRest = (handle: DeformHandle, rest: Float64Array): DeformHandle =>
  handle.kind === 'region'
    ? { ...handle, matrix: [...IDENTITY] }
    : { ...handle, position: [...pointAt(rest, handle.vertices[0]!)] };

/**
 * The step with handle `index` holding exactly `vertices` (a new handle where `index` is null). They leave
 * the other handles; a region that empties goes. A new handle starts where the surface is now, turned as
 * the surface is turned, so that painting on a bent model does not snap it back.
 */
export function setHandleVertices(
  scene: Pick<DeformScene, 'step' | 'rest' | 'posed'>,
  index: number | null,
  vertices: Uint32Array,
  name: string,
): DeformEdit {
  const { step, rest, posed } = scene;
  const count = rest.length / 3;
  const points = new Set(step.handles.flatMap((h) => (h.kind === 'point' ? h.vertices : [])));
  const own = new Set(vertices.filter((v) => !points.has(v)));
  const handles: DeformHandle[] = [];
  let selected: number | null = null;
  step.handles.forEach((handle, i) => {
    const isOwn = i === index;
    const kept: DeformHandle =
      handle.kind === 'point'
        ? handle
        : { ...handle, vertices: isOwn ? fromIndices(own, count) : without(handle.vertices, own, count) };
    if (isEmpty(kept.vertices)) return;
    if (isOwn) selected = handles.length;
    handles.push(kept);
  });
  if (index === null && own.size > 0) {
    selected = handles.length;
    const matrix = [...rigidFit(rest, posed, Uint32Array.from(own))];
    handles.push({ kind: 'region', vertices: fromIndices(own, count), matrix, name });
  }
  return { step: { ...step, handles }, selected };
}

/** The step with a point handle more, at the place where its vertex is now. */
export function addPoint(
  { step, posed }: Pick<DeformScene, 'step' | 'posed'>,
  vertex: number,
  name: string,
): DeformEdit {
  const handle: DeformHandle = {
    kind: 'point',
    vertices: [vertex],
    position: [...pointAt(posed, vertex)],
    name,
  };
  return { step: { ...step, handles: [...step.handles, handle] }, selected: step.handles.length };
}

const contains = (set: DeformHandle['vertices'], vertex: number, count: number): boolean => {
  if (set === 'all') return vertex < count;
  if ('ranges' in set) return set.ranges.some(([first, last]) => first <= vertex && vertex <= last);
  return set.includes(vertex);
};

function without(set: DeformHandle['vertices'], gone: ReadonlySet<number>, count: number) {
  const indices = toIndices(set, count);
  return indices.some((v) => gone.has(v))
    ? fromIndices(
        indices.filter((v) => !gone.has(v)),
        count,
      )
    : set;
}
