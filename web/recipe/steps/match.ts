import * as v from 'valibot';
import {
  between,
  coordinate,
  index,
  length,
  list,
  listUpTo,
  oneOf,
  reference,
  stepId,
  vec3,
  vertexSet,
  wholeBetween,
} from '../schema-parts';

/** Models of one match. */
export const MAX_MATCHED = 12;
/** Pairs of markers that a person sets, many times over. */
export const MAX_MARKERS = 500;
export const MAX_MARKER_CURVES = 100;
/** Places of one marker curve. */
export const MAX_CURVE_PLACES = 500;
/** Handles of a first skin that is asked for. */
export const MAX_GENUS = 20;

/** Somewhere on a model: a vertex, on a face by one weight for each of its corners, or near a point. */
const place = v.union(
  [
    index,
    v.strictObject({
      face: index,
      at: v.pipe(
        listUpTo(1000, coordinate),
        v.minLength(3, 'a weight for each corner'),
        v.check(
          (weights) => Math.abs(weights.reduce((sum, each) => sum + each, 0) - 1) < 1e-6,
          'weights that sum to 1',
        ),
      ),
    }),
    v.strictObject({ point: vec3 }),
  ],
  oneOf(['face', 'at', 'point'], 'a vertex, { "face", "at": [weights] } or { "point": [x, y, z] }'),
);

/**
 * One connectivity for several models (Skins): it leaves a skin for each, `<id>/<model>`, vertex i of one belonging to vertex i of
 * every other. The first model is the source.
 */
export const matchStep = v.strictObject({
  id: stepId,
  type: v.literal('match'),
  models: v.pipe(
    listUpTo(MAX_MATCHED, reference),
    v.minLength(2, 'two models or more'),
    v.check((names) => new Set(names).size === names.length, 'models that are all different'),
  ),
  /**
   * What belongs together: for each marker one place per model, in their order; `null` where it is not set yet, and then the
   * marker is left out. None at all, or three and more that are set everywhere.
   */
  markers: v.optional(listUpTo(MAX_MARKERS, listUpTo(MAX_MATCHED, v.nullable(place))), []),
  /** That the skins' edges shall have, in units of the source; its own when left out. */
  edgeLength: v.optional(length),
  /** How much finer skins are where surfaces bend more. */
  adapt: v.optional(between(0, 1), 0),
  /** Edges with a larger angle between their faces, in degrees, stay sharp; none when left out. */
  sharpAngle: v.optional(between(1, 180)),
  /** More sharp edges, picked: for each model, in their order, rows of vertices along its edges. */
  sharp: v.optional(listUpTo(MAX_MATCHED, listUpTo(MAX_MARKER_CURVES, list(index)))),
  /** Lines that belong together: for each curve a row of places per model, in their order; left out while one is empty. */
  curves: v.optional(listUpTo(MAX_MARKER_CURVES, listUpTo(MAX_MATCHED, listUpTo(MAX_CURVE_PLACES, place)))),
  /** What is ignored of each model, in their order: holes, hair, a stand. */
  mask: v.optional(listUpTo(MAX_MATCHED, vertexSet)),
  /**
   * What the first skin is: the source, the source cut anew, a skin wrapped around it, or a simple shape. Left out: the source where
   * it hangs together, else a wrap.
   */
  first: v.optional(v.picklist(['copy', 'remesh', 'wrap', 'box', 'sphere', 'torus'])),
  /** Tunnels that a wrapped skin should have; none when left out. */
  genus: v.optional(wholeBetween(0, MAX_GENUS)),
  /** By a graph of affine maps, or one particle at a time as the paper has it. */
  method: v.optional(v.picklist(['graph', 'paper']), 'graph'),
  /** Several models on one first skin from the start; or by pairs, composed afterwards as the paper has it. For two it is the same. */
  together: v.optional(v.boolean(), true),
  /** How the source is first laid on the others: moved, bent by the markers, or whichever does better. */
  start: v.optional(v.picklist(['automatic', 'similarity', 'radial']), 'automatic'),
});

export type MatchStep = v.InferOutput<typeof matchStep>;
export type MarkerPlace = v.InferOutput<typeof place>;

type Marker = MatchStep['markers'][number];

/** Whether a marker is set on every model. */
export const isWhole = (marker: Marker): marker is MarkerPlace[] => marker.every((place) => place !== null);

/** A curve needs two places on every model. */
export const isDrawn = (rows: readonly (readonly MarkerPlace[])[]): boolean =>
  rows.every(({ length }) => length > 1);

/** A match step as it starts: nothing is marked yet. */
export const newMatchStep = (id: string, models: readonly string[]): MatchStep =>
  v.parse(matchStep, { id, type: 'match', models });
