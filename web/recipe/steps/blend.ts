import * as v from 'valibot';
import { MAX_COORDINATE } from '../limits';
import {
  between,
  index,
  itemName,
  length,
  listUpTo,
  memberName,
  severalReference,
  stepId,
  vec3,
  vertexSet,
} from '../schema-parts';
import type { Member } from '../step-row';

/** Beyond that a blend is a caricature of a caricature. */
export const MAX_WEIGHT = 10;
export const MAX_PARTS = 50;
export const MAX_MEASURES = 50;
/** Vertices of one loop or path. */
export const MAX_MEASURED = 10_000;

const name = v.optional(itemName);

const part = v.strictObject({
  name,
  /** Whose shape it takes. */
  from: memberName,
  /** Of the skins. */
  vertices: vertexSet,
  /** How far around the part the skin goes over from one shape to the other, in units of `from`; as suits the part when left out. */
  feather: v.optional(between(0, MAX_COORDINATE)),
  /** `paste`: all of it, turned and scaled to fit. `low-pass`: what stands out of it, as the paper has it. */
  how: v.optional(v.picklist(['paste', 'low-pass']), 'paste'),
});

/** What is wanted; left out: it is only measured. */
const value = v.optional(length);
const hull = v.optional(v.boolean(), false);

const kinds = v.variant('kind', [
  /** Extent along a direction. */
  v.strictObject({ kind: v.literal('height'), name, up: v.optional(vec3, [0, 1, 0]), value }),
  /**
   * Length of a closed line: where the plane through a vertex of the skins, square to `normal`, cuts them around that vertex, or
   * through vertices. `hull`: as a tape would lie, over hollows.
   */
  v.strictObject({
    kind: v.literal('girth'),
    name,
    vertex: v.optional(index),
    normal: v.optional(vec3, [0, 1, 0]),
    loop: v.optional(listUpTo(MAX_MEASURED, index)),
    hull,
    value,
  }),
  /** Along straight lines from vertex to vertex. */
  v.strictObject({
    kind: v.literal('length'),
    name,
    path: v.pipe(listUpTo(MAX_MEASURED, index), v.minLength(2, 'two vertices or more')),
    value,
  }),
]);

const measure = v.pipe(
  kinds,
  v.check(
    (m) => m.kind !== 'girth' || (m.vertex === undefined) !== (m.loop === undefined),
    'a girth by a "vertex" or by a "loop"',
  ),
);

/**
 * A shape between those that a match step brought to one connectivity: their sum by weights, parts taken from one of them, weights
 * found so that measures come out (Skins 5.1).
 */
export const blendStep = v.strictObject({
  id: stepId,
  type: v.literal('blend'),
  match: severalReference,
  /** By model; one that is left out counts for nothing. With wanted measures: what is kept to where these leave room. */
  weights: v.record(memberName, between(-MAX_WEIGHT, MAX_WEIGHT)),
  parts: v.optional(listUpTo(MAX_PARTS, part), []),
  measures: v.optional(listUpTo(MAX_MEASURES, measure), []),
});

export type BlendStep = v.InferOutput<typeof blendStep>;
export type BlendPart = v.InferOutput<typeof part>;
export type BlendMeasure = v.InferOutput<typeof measure>;

export const blendMembers = ({ weights, parts }: BlendStep): Member[] => [
  ...Object.keys(weights).map((name) => ({ path: ['weights', name], name })),
  ...parts.map(({ from }, at) => ({ path: ['parts', at, 'from'], name: from })),
];

/** A blend step as it starts: as much of each. */
export const newBlendStep = (id: string, match: string, models: readonly string[]): BlendStep =>
  v.parse(blendStep, {
    id,
    type: 'blend',
    match,
    weights: Object.fromEntries(models.map((name) => [name, 1 / models.length])),
  });
