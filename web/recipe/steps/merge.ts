import * as v from 'valibot';
import { MAX_HANDLES } from '../limits';
import {
  between,
  coordinate,
  index,
  length,
  list,
  listUpTo,
  matrix,
  positiveUpTo,
  reference,
  stepId,
  vertexSet,
  wholeBetween,
} from '../schema-parts';

/** Pairs of boundaries; a mesh joined along more of them would be a net. */
const MAX_BOUNDARIES = 100;
/** Between the coarsest and the finest unit that two models come in. */
const MAX_SCALE = 1e9;
/** Some turns too many do no harm. */
const MAX_DEGREES = 1e6;

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

/** Widths along the two surfaces, in their own units; the weight is w_T of E_T (Fu 3.3.3). */
const transition = v.strictObject({
  sourceWidth: length,
  targetWidth: length,
  weight: v.optional(between(0, MAX_SCALE), 0.1),
});

/** How the source's plane map lies on the target's: scaled, turned (degrees), then moved. */
const placement = v.strictObject({
  shift: v.strictTuple([coordinate, coordinate], 'two numbers'),
  turn: between(-MAX_DEGREES, MAX_DEGREES),
  scale: positiveUpTo(MAX_SCALE),
});

const rounds = wholeBetween(0, 100);

/** Painted regions; the boundary is found between the feature and the edge of the source region. */
const optimalBoundary = v.strictObject({
  sourceRegion: vertexSet,
  feature: vertexSet,
  targetRegion: vertexSet,
  placement: v.optional(placement),
  /** Rounds of seeking at most; 0: the edge of the source region is the boundary. As many as help when left out. */
  rounds: v.optional(rounds),
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
  boundaries: v.optional(listUpTo(MAX_BOUNDARIES, boundary), []),
  optimalBoundary: v.optional(optimalBoundary),
  /** With `boundaries` only. */
  transition: v.optional(transition),
  roi: v.optional(vertexSet, 'all'),
  handles: v.optional(listUpTo(MAX_HANDLES, handle), []),
  pose: v.optional(matrix),
  smoothing: v.optional(rounds, 1),
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
