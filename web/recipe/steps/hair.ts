import * as v from 'valibot';
import { MAX_COORDINATE } from '../limits';
import {
  between,
  grouped,
  length,
  listUpTo,
  reference,
  stepId,
  vec3,
  vertexSet,
  wholeBetween,
} from '../schema-parts';

/** More would not fit a browser's memory; a real head has about a hundred thousand. */
export const MAX_STRANDS = 1_000_000;
const MAX_PRIMITIVES = 500;
const MAX_POINTS = 2000;
/** Painted lengths have three digits from 0 to 2. */
const MAX_LENGTHS = 5000;

const label = {
  name: v.optional(v.pipe(v.string(), v.maxLength(64, 'a name of at most 64 characters'))),
  hidden: v.optional(v.boolean()),
};

const share = between(0, 1);

const line = listUpTo(MAX_POINTS, vec3, `at most ${grouped(MAX_POINTS)} points`);
const some = <const S extends v.GenericSchema>(item: S) =>
  listUpTo(MAX_PRIMITIVES, item, `at most ${MAX_PRIMITIVES} of them`);

const stream = v.strictObject({ points: line, fade: v.optional(v.boolean(), false), ...label });

const parting = v.strictObject({
  points: line,
  tilt: v.optional(v.strictTuple([between(-90, 90), between(-90, 90)], 'two angles'), [0, 0]),
  sigma: v.optional(between(0.1, 10), 1),
  height: v.optional(between(0, 10), 0.5),
  ...label,
});

/** Drawn part by part, so all but the spine may still be missing. */
const ponytail = v.strictObject({
  spine: line,
  section: v.optional(line, []),
  profiles: v.optional(listUpTo(2, line, 'at most two profiles'), []),
  tightness: v.optional(share, 0.6),
  ...label,
});

const HEX = 'a colour like #5a3825';

/** Strokes are in model space, lengths in model units, sigma and height in grid steps (Fu ch. 4). */
export const hairStep = v.strictObject({
  id: stepId,
  type: v.literal('hair'),
  model: reference,
  /** Left out: the scalp that the model brings. */
  scalp: v.optional(vertexSet),
  grid: v.optional(v.strictObject({ resolution: v.optional(wholeBetween(16, 96), 48) }), {}),
  streams: v.optional(some(stream), []),
  partings: v.optional(some(parting), []),
  ponytails: v.optional(some(ponytail), []),
  strands: v.optional(
    v.strictObject({
      count: v.optional(wholeBetween(0, MAX_STRANDS), 30_000),
      seed: v.optional(wholeBetween(0, 2 ** 31 - 1), 1),
      step: v.optional(between(0.1, 2), 0.5),
    }),
    {},
  ),
  length: v.optional(
    v.strictObject({
      /** Longest strand; the head's height when left out. */
      max: v.optional(length),
      variation: v.optional(share, 0.2),
      /** Painted: a factor of the length, where parts overlap the last one counts. */
      map: v.optional(
        listUpTo(MAX_LENGTHS, v.strictObject({ vertices: vertexSet, factor: between(0, 2) })),
        [],
      ),
    }),
    {},
  ),
  /** Height of the hair over the skin; 3 % of the head's height when left out. */
  volume: v.optional(between(0, MAX_COORDINATE)),
  detail: v.optional(
    v.strictObject({
      clump: v.optional(share, 0.4),
      curl: v.optional(share, 0),
      curlLength: v.optional(length),
      frizz: v.optional(share, 0.25),
      flyaways: v.optional(share, 0.02),
    }),
    {},
  ),
  material: v.optional(
    v.strictObject({
      /** Goes before melanin. */
      color: v.optional(v.pipe(v.string(), v.regex(/^#[0-9a-f]{6}$/i, HEX))),
      /** 0 white, 0.3 blond, 0.6 brown, 1 black. */
      melanin: v.optional(share, 0.6),
      /** Share of the red kind of melanin. */
      redness: v.optional(share, 0.2),
      colorVariation: v.optional(share, 0.2),
      /** Diameter at the root, model units. Left out: 0.08 mm on a head 24 cm high, up to twice that below 100,000 strands. */
      thickness: v.optional(length),
      /** Diameter at the tip as a share of it. */
      taper: v.optional(share, 0.35),
    }),
    {},
  ),
});

export type HairStep = v.InferOutput<typeof hairStep>;

/** A hair step as it starts: nothing drawn, everything at its default. */
export const newHairStep = (id: string, model: string): HairStep =>
  v.parse(hairStep, { id, type: 'hair', model });
