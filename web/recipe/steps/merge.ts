import * as v from 'valibot';
import { finite, index, list, matrix, reference, stepId, vertexSet } from '../schema-parts';

const key = v.strictTuple([index, index], 'a pair of a source vertex and a target vertex');

const boundary = v.strictObject({
  source: list(index),
  target: list(index),
  /** None: the best one is found. */
  keys: v.optional(list(key), []),
  /** Vertices of the side to keep, where the loop is a path across the surface; none: the side to its left. */
  sourceKeep: v.optional(vertexSet, []),
  targetKeep: v.optional(vertexSet, []),
});

const handle = v.strictObject({
  vertices: vertexSet,
  matrix: v.optional(matrix),
  name: v.optional(v.pipe(v.string(), v.maxLength(64, 'a name of at most 64 characters'))),
});

const POSITIVE = 'a number above 0';
const positive = v.pipe(
  finite,
  v.check((number) => number > 0, POSITIVE),
);

/** Widths along the two surfaces, in their own units; the weight is w_T of E_T (Fu 3.3.3). */
const transition = v.strictObject({
  sourceWidth: positive,
  targetWidth: positive,
  weight: v.optional(v.pipe(finite, v.minValue(0, 'a number from 0 on')), 0.1),
});

/** How the source's plane map lies on the target's: scaled, turned (degrees), then moved. */
const placement = v.strictObject({
  shift: v.strictTuple([finite, finite], 'two numbers'),
  turn: finite,
  scale: positive,
});

const ROUNDS = 'a whole number from 0 to 100';

/** Painted regions; the boundary is found between the feature and the edge of the source region. */
const optimalBoundary = v.strictObject({
  sourceRegion: vertexSet,
  feature: vertexSet,
  targetRegion: vertexSet,
  placement: v.optional(placement),
  /** Rounds of seeking at most; 0: the edge of the source region is the boundary. As many as help when left out. */
  rounds: v.optional(v.pipe(v.number(), v.integer(ROUNDS), v.minValue(0, ROUNDS), v.maxValue(100, ROUNDS))),
});

/**
 * Joins a source to a target along pairs of boundaries (Fu ch. 3). Vertex indices are those of the step's two input
 * models. Either `boundaries` or `optimalBoundary` says where; `roi`, `handles` and `pose` are read by dependent merging.
 */
export const mergeStep = v.strictObject({
  id: stepId,
  type: v.literal('merge'),
  source: reference,
  target: reference,
  mode: v.optional(v.picklist(['independent', 'dependent']), 'independent'),
  boundaries: v.optional(list(boundary), []),
  optimalBoundary: v.optional(optimalBoundary),
  /** With `boundaries` only. */
  transition: v.optional(transition),
  roi: v.optional(vertexSet, 'all'),
  handles: v.optional(list(handle), []),
  pose: v.optional(matrix),
  smoothing: v.optional(
    v.pipe(v.number(), v.integer(ROUNDS), v.minValue(0, ROUNDS), v.maxValue(100, ROUNDS)),
    1,
  ),
});

export type MergeStep = v.InferOutput<typeof mergeStep>;

/** A merge step as it starts: nothing is marked yet. */
export const newMergeStep = (id: string, source: string, target: string): MergeStep => ({
  id,
  type: 'merge',
  source,
  target,
  mode: 'independent',
  boundaries: [],
  roi: 'all',
  handles: [],
  smoothing: 1,
});
