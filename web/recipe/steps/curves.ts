import * as v from 'valibot';
import {
  between,
  length,
  list,
  listUpTo,
  positiveUpTo,
  reference,
  stepId,
  vec3,
  vertexSet,
  wholeBetween,
} from '../schema-parts';

/** Curves of a step: limbs and tentacles, not hairs. */
export const MAX_CURVES = 100;
/** Control points of one curve. */
export const MAX_CONTROLS = 200;
/** Lines that stay beside one that is pulled. */
export const MAX_HELD = 60;
/** Poses that a step keeps. */
export const MAX_POSES = 200;
/** Ten turns either way. */
export const MAX_TWIST = 3600;
export const MAX_SCALE = 100;
/** Seconds. */
const MAX_TIME = 3600;

const controls = v.pipe(listUpTo(MAX_CONTROLS, vec3), v.minLength(2, 'two control points or more'));

/** A rotation, (x, y, z, w); its length does not matter. */
const quaternion = v.pipe(
  v.strictTuple([between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)], 'four numbers'),
  v.check((q) => Math.hypot(...q) > 0.1, 'a rotation: four numbers (x, y, z, w) that are not all about 0'),
);

const factor = positiveUpTo(MAX_SCALE);

/** How one curve is posed. What is left out is as at rest. */
const posture = {
  /** As many control points as at rest; a linked curve's in the frame of its parent at rest. */
  posed: v.optional(controls),
  /** How the whole curve was turned: what points cannot tell. */
  base: v.optional(quaternion),
  /** Degrees about the curve, at each control point. */
  twist: v.optional(listUpTo(MAX_CONTROLS, between(-MAX_TWIST, MAX_TWIST))),
  /** Across the curve, in its two directions, at each control point. */
  scale: v.optional(listUpTo(MAX_CONTROLS, v.strictTuple([factor, factor], 'two numbers'))),
};

const curve = v.strictObject({
  id: stepId,
  /** Along the middle of a limb, on its surface, or a line of the drawing that is pulled. */
  kind: v.picklist(['skeleton', 'surface', 'contour']),
  rest: controls,
  ...posture,
  /** Segments that stay straight: number k runs from control point k to the next. */
  rigid: v.optional(list(wholeBetween(0, MAX_CONTROLS - 2))),
  /** What follows the curve; found when left out. */
  region: v.optional(vertexSet),
  /** The end that stays where it is; the one with more of the model beyond it when left out. */
  anchor: v.optional(v.picklist(['start', 'end'])),
  /** Of a contour: how far its pull goes along the surface, model units; 0.13 of the largest extent when left out. */
  reach: v.optional(length),
  /** Of a contour: lines beside it that stay, control points each. */
  held: v.optional(listUpTo(MAX_HELD, controls)),
});

/** The child takes over how the parent moves at a place of it: 0 is the parent's start, 1 its end. */
const link = v.strictObject({ child: stepId, parent: stepId, at: between(0, 1) });

const pose = v.strictObject({
  name: v.pipe(v.string(), v.minLength(1, 'a name'), v.maxLength(64, 'a name of at most 64 characters')),
  /** Seconds from the beginning, when poses are played. */
  time: v.optional(between(0, MAX_TIME)),
  /** Curves that are not named are at rest. */
  curves: listUpTo(MAX_CURVES, v.strictObject({ id: stepId, ...posture })),
});

const options = v.strictObject({
  /** How linked curves share what lies between them. */
  blending: v.optional(v.picklist(['ownership', 'geodesic', 'gaussian']), 'ownership'),
  /** `slabs`: the thesis's 200 planes. */
  encoding: v.optional(v.picklist(['kernel', 'slabs']), 'kernel'),
  /** What keeps a tight bend from folding. */
  guard: v.optional(v.picklist(['symmetric', 'thesis', 'none']), 'symmetric'),
});

/**
 * Bends a model by curves (Blanco 2007). Each moves its part of the model; linked ones make a skeleton. Vertex indices
 * are those of the step's input model. `poses` are kept for playing; what the step leaves is the posture of its curves.
 */
export const curvesStep = v.strictObject({
  id: stepId,
  type: v.literal('curves'),
  model: reference,
  curves: listUpTo(MAX_CURVES, curve),
  links: v.optional(listUpTo(MAX_CURVES, link), []),
  options: v.optional(options, {}),
  poses: v.optional(listUpTo(MAX_POSES, pose), []),
});

export type CurvesStep = v.InferOutput<typeof curvesStep>;
export type Curve = CurvesStep['curves'][number];
export type CurvePosture = Pick<Curve, 'posed' | 'base' | 'twist' | 'scale'>;

/** A curves step as it starts: nothing is drawn yet. */
export const newCurvesStep = (id: string, model: string): CurvesStep =>
  v.parse(curvesStep, { id, type: 'curves', model, curves: [] });
