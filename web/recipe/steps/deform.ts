import * as v from 'valibot';
import { MAX_HANDLES } from '../limits';
import {
  index,
  itemName,
  list,
  listUpTo,
  matrix,
  reference,
  stepId,
  vec3,
  vertexSet,
  wholeBetween,
} from '../schema-parts';

const label = {
  name: v.optional(itemName),
  hidden: v.optional(v.boolean()),
};

const regionHandle = v.strictObject({ kind: v.literal('region'), vertices: vertexSet, matrix, ...label });

const pointHandle = v.strictObject({
  kind: v.literal('point'),
  vertices: v.pipe(list(index), v.length(1, 'exactly one vertex')),
  position: vec3,
  ...label,
});

const options = v.strictObject({
  removeShear: v.optional(v.boolean(), true),
  scaleDetails: v.optional(v.boolean(), false),
  iterations: v.optional(wholeBetween(1, 100), 1),
  coherenceRing: v.optional(v.picklist([1, 2]), 1),
  // Of the isoline method, which has its own defaults: none here, so that recipes without it stay as they are.
  /** Control transformations a handle. */
  isolines: v.optional(wholeBetween(3, 100)),
  basis: v.optional(v.picklist(['quadratic', 'hats'])),
  local: v.optional(v.picklist(['patches', 'isolines', 'positions'])),
  sampledTriangles: v.optional(wholeBetween(10, 10_000)),
  /** How it ends: as it was dragged, or with one full implicit pass. */
  settle: v.optional(v.picklist(['reduced', 'full'])),
});

/** Bends a region of interest by handles (Fu ch. 2; Isolines). Vertex indices are those of the step's input model. */
export const deformStep = v.strictObject({
  id: stepId,
  type: v.literal('deform'),
  model: reference,
  roi: v.optional(vertexSet, 'all'),
  handles: listUpTo(MAX_HANDLES, v.variant('kind', [regionHandle, pointHandle])),
  method: v.optional(v.picklist(['implicit', 'iterative', 'naive', 'isolines']), 'implicit'),
  options: v.optional(options, {}),
});

export type DeformStep = v.InferOutput<typeof deformStep>;
export type DeformHandle = DeformStep['handles'][number];

/** A deform step as it starts: everything may move, nothing is held yet. */
export const newDeformStep = (id: string, model: string): DeformStep =>
  v.parse(deformStep, { id, type: 'deform', model, handles: [] });
