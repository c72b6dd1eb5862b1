// The curves step: regions and places along curves once per rest drawing, then only their postures change.

import { LissomError } from '../../core/errors';
import { withPositions } from '../../core/model';
import type { Args } from '../../kernel/contract';
import type { Curve, CurvePosture, CurvesStep } from '../../recipe/steps/curves';
import type { ModelResult } from '../types';
import { checkVertices, vertexSetKey } from '../vertex-sets';
import { postureOf, prepareCurves } from './curves/kernel-words';
import { pullWeights, viewLines } from './curves/lines';
import { skinOf } from './curves/skin';
import { type StepContext, type StepOutcome, type StepRunner, signalOf } from './step-runner';

export interface CurvesFigures {
  readonly curves: number;
  /** Pairs of triangles without a common vertex that meet; not counted for a preview. */
  readonly selfIntersections?: { readonly before: number; readonly after: number };
  /** Folds begin where `bend` is 1; the guard turned planes by up to `tilt` degrees. */
  readonly bend: number;
  readonly tilt: number;
}

const UNTIMED = { regions: 0, encode: 0, pose: 0 };

export const curvesRunner = {
  /** The one on screen, and the one to switch back to. */
  keeps: { prepareCurves: 2, prepareSketch: 1, prepareContours: 1 },

  questions: {
    /** The curve that a stroke on the step's input means. */
    sketchedCurve: async (_: CurvesStep, context: StepContext, args: Omit<Args<'sketchCurve'>, 'sketch'>) =>
      context.kernel.call(
        'sketchCurve',
        { sketch: (await prepareSketch(context)).id, ...args },
        signalOf(context),
      ),
    /** What would follow the curve that a stroke means. */
    strokeRegion: async (_: CurvesStep, context: StepContext, args: Omit<Args<'curveRegion'>, 'sketch'>) =>
      context.kernel.call(
        'curveRegion',
        { sketch: (await prepareSketch(context)).id, ...args },
        signalOf(context),
      ),
    /** Where the vertices are in another posture of the same curves. */
    posedBy: async (
      step: CurvesStep,
      context: StepContext,
      { curves }: { readonly curves: readonly CurvePosture[] },
    ) =>
      context.kernel.call(
        'poseCurves',
        { curves: (await prepareCurves(step, context)).id, postures: curves.map(postureOf) },
        signalOf(context),
      ),
    /** Curves to begin with. */
    proposedCurves: async (_: CurvesStep, context: StepContext) =>
      context.kernel.call('proposeCurves', { sketch: (await prepareSketch(context)).id }, signalOf(context)),
    /** What follows each curve, and which end of it stays; the same object for as long as that holds. */
    preparedCurves: prepareCurves,
    /** A pose for the graphics card, and by what object it may know that its `curveAttributes` still hold. */
    curveTable: async (step: CurvesStep, context: StepContext) => {
      const prepared = await prepareCurves(step, context);
      const args = { curves: prepared.id, postures: step.curves.map(postureOf) };
      return { ...(await context.kernel.call('curveTable', args, signalOf(context))), prepared };
    },
    /** What the graphics card needs once. */
    curveAttributes: async (step: CurvesStep, context: StepContext) =>
      context.kernel.call(
        'curveAttributes',
        { curves: (await prepareCurves(step, context)).id },
        signalOf(context),
      ),
    /** What each curve takes over from its parent. */
    curveParents: async (step: CurvesStep, context: StepContext) =>
      context.kernel.call(
        'curveParents',
        { curves: (await prepareCurves(step, context)).id, postures: step.curves.map(postureOf) },
        signalOf(context),
      ),
    /** How far a drag from the step's posture to another may go. */
    curveDragLimit: async (
      step: CurvesStep,
      context: StepContext,
      { to }: { readonly to: readonly CurvePosture[] },
    ) =>
      context.kernel.call(
        'curveDragLimit',
        {
          curves: (await prepareCurves(step, context)).id,
          from: step.curves.map(postureOf),
          to: to.map(postureOf),
        },
        signalOf(context),
      ),
    chainReach: async (_: CurvesStep, context: StepContext, args: Args<'reachCurve'>) =>
      context.kernel.call('reachCurve', args, signalOf(context)),
    /** The curves as joints, and the poses that are kept as an animation. */
    skin: (step: CurvesStep, context: StepContext) => skinOf(step, context),
    /** Contours and suggestive contours of a view of the step's surface. */
    viewLines,
    /** How much of a contour's pull each vertex takes. */
    pullWeights,
    /** Faces that meet others, at these positions of the input's vertices. */
    crossingFaces: async (
      _: CurvesStep,
      context: StepContext,
      { positions }: { readonly positions: Float64Array },
    ) =>
      context.kernel.call(
        'selfIntersections',
        { model: context.inputs[0]!.opened.id, positions },
        signalOf(context),
      ),
  },

  check(step, path, [input]) {
    const known = new Set<string>();
    for (const [at, curve] of step.curves.entries()) {
      const place = `${path}.curves[${at}]`;
      if (known.has(curve.id))
        throw wrong(`${place}.id: there are two curves ${quoted(curve.id)}; rename one.`);
      known.add(curve.id);
      checkPosture(curve, curve.rest.length, place);
      const segments = curve.rest.length - 1;
      const lost = curve.rigid?.find((segment) => segment >= segments);
      if (lost !== undefined)
        throw wrong(
          `${place}.rigid: there is no segment ${lost}; the curve has segments 0 to ${segments - 1}.`,
        );
      for (const field of ['reach', 'held'] as const)
        if (curve[field] !== undefined && curve.kind !== 'contour')
          throw wrong(
            `${place}.${field}: only a curve of kind "contour" has it; remove it or change the kind.`,
          );
      if (curve.region && input) checkVertices(curve.region, `${place}.region`, input);
    }
    checkLinks(step, path, known);
    checkPoses(step, path);
  },

  vertexCount: ([input]) => input?.vertices,

  /** Poses are kept for the app to play; what the step leaves does not depend on them. */
  content: ({ curves, links, options }) => ({
    curves: curves.map(({ region, ...curve }) => ({ ...curve, region: region && vertexSetKey(region) })),
    links,
    options,
  }),

  async run(step, context): Promise<StepOutcome<CurvesFigures>> {
    const [input] = context.inputs as [ModelResult];
    if (step.curves.length === 0) return unchanged(input);
    const signal = signalOf(context);
    const prepared = await prepareCurves(step, context);
    const posed = await context.kernel.call(
      'poseCurves',
      { curves: prepared.id, postures: step.curves.map(postureOf) },
      signal,
    );
    const crossings = context.settle ? await countCrossings(context, posed.positions) : {};
    return {
      model: withPositions(input.model, posed.positions),
      figures: { curves: step.curves.length, bend: posed.bend, tilt: posed.tilt, ...crossings },
      seconds: { ...prepared.seconds, ...posed.seconds },
      peakBytes: prepared.peakBytes,
      warnings: prepared.warnings,
    };
  },
} satisfies StepRunner<CurvesStep>;

/** What strokes on the step's input are read with: who neighbours whom, what a ray meets. */
function prepareSketch(context: StepContext) {
  const [input] = context.inputs as [ModelResult];
  return context.kernel.hold('prepareSketch', input.key, { model: input.opened.id }, signalOf(context));
}

const counted = new WeakMap<Float64Array, number>();

async function countCrossings(context: StepContext, positions: Float64Array) {
  const [input] = context.inputs as [ModelResult];
  const count = async (at: Float64Array) =>
    (
      await context.kernel.call(
        'selfIntersections',
        { model: input.opened.id, positions: at },
        signalOf(context),
      )
    ).pairs;
  const rest = input.model.positions;
  const before = counted.get(rest) ?? (await count(rest));
  counted.set(rest, before);
  return { selfIntersections: { before, after: await count(positions) } };
}

function checkPosture(given: Omit<Curve, 'id' | 'kind' | 'rest'>, controls: number, place: string): void {
  for (const field of ['posed', 'twist', 'scale'] as const) {
    const found = given[field]?.length;
    if (found === undefined || found === controls) continue;
    throw wrong(
      `${place}.${field}: expected ${controls} entries, one for each control point at rest, but there are ${found}.`,
    );
  }
}

function checkLinks({ links }: CurvesStep, path: string, known: ReadonlySet<string>): void {
  const parents = new Map<string, string>();
  for (const [at, { child, parent }] of links.entries()) {
    const place = `${path}.links[${at}]`;
    for (const [field, id] of Object.entries({ child, parent }))
      if (!known.has(id)) throw wrong(`${place}.${field}: there is no curve ${quoted(id)} in this step.`);
    if (parents.has(child))
      throw wrong(`${place}.child: ${quoted(child)} has a parent already; a curve hangs on one other.`);
    parents.set(child, parent);
    for (let up: string | undefined = parent; up !== undefined; up = parents.get(up))
      if (up === child)
        throw wrong(`${place}: this link closes a ring at ${quoted(child)}; remove one of the links.`);
  }
}

function checkPoses({ curves, poses }: CurvesStep, path: string): void {
  const controls = new Map(curves.map(({ id, rest }) => [id, rest.length]));
  for (const [at, pose] of poses.entries())
    for (const [k, posture] of pose.curves.entries()) {
      const place = `${path}.poses[${at}].curves[${k}]`;
      const count = controls.get(posture.id);
      if (count === undefined)
        throw wrong(`${place}.id: there is no curve ${quoted(posture.id)} in this step.`);
      checkPosture(posture, count, place);
    }
}

const wrong = (message: string): LissomError => new LissomError('curve-invalid', message);
const quoted = (text: string): string => JSON.stringify(text);

const unchanged = ({ model }: ModelResult): StepOutcome<CurvesFigures> => ({
  model,
  figures: { curves: 0, bend: 0, tilt: 0, selfIntersections: { before: 0, after: 0 } },
  seconds: UNTIMED,
  peakBytes: 0,
  warnings: [],
});
