// The blend step: shapes between skins of one connectivity (Skins 5.1). Parts are factored once, weights and measures are then cheap.

import { type Finding, LissomError } from '../../core/errors';
import { hashValue } from '../../core/hash';
import { type Model, vertexCount, withPositions } from '../../core/model';
import { toIndices } from '../../core/vertex-set';
import type { Blended, MeasureSpec } from '../../kernel/contract/wear';
import type { BlendMeasure, BlendStep } from '../../recipe/steps/blend';
import { carriedRig } from '../carried-rig';
import type { ModelResult } from '../types';
import { checkVertices, vertexSetKey } from '../vertex-sets';
import { type StepContext, type StepOutcome, type StepRunner, signalOf } from './step-runner';

export interface BlendFigures {
  /** By model: as given, or as the measures ask. */
  readonly weights: Readonly<Record<string, number>>;
  /** In the order of the step's. */
  readonly measures: readonly {
    readonly kind: BlendMeasure['kind'];
    readonly reached: number;
    /** What was wanted, and how far the shape is from it. */
    readonly value?: number;
    readonly residual?: number;
  }[];
  readonly iterations: number;
}

/** How far weights may be from making a whole before it is said. */
const WHOLE = 1e-6;

export const blendRunner = {
  /** The one on screen, and the one to switch back to. */
  keeps: { prepareBlend: 2 },

  check(step, path, [skin]) {
    if (Object.keys(step.weights).length === 0 && !step.measures.some(isWanted))
      throw new LissomError('no-weights', `${path}.weights: there are none; give one to at least one model.`);
    if (!skin) return;
    for (const [at, { vertices }] of step.parts.entries())
      checkVertices(vertices, `${path}.parts[${at}].vertices`, skin);
    for (const [at, measure] of step.measures.entries())
      checkVertices(verticesOf(measure), `${path}.measures[${at}]`, skin);
  },

  vertexCount: ([skin]) => skin?.vertices,

  /** What parts and measures are called changes nothing. */
  content: ({ id: _id, match: _match, parts, measures, ...rest }) => ({
    ...rest,
    parts: parts.map(({ vertices, name: _name, ...part }) => ({ ...part, vertices: vertexSetKey(vertices) })),
    measures: measures.map(({ name: _name, ...measure }) => measure),
  }),

  async run(step, context): Promise<StepOutcome<BlendFigures>> {
    const { names, weights, skin, skins } = given(step, context);
    const prepared = await prepareBlend(step, context);
    const blended = await context.kernel.call(
      'blend',
      { blend: prepared.id, weights, measures: step.measures.map(specOf) },
      signalOf(context),
    );
    const sum = weights.reduce((all, each) => all + each, 0);
    const loose = !step.measures.some(isWanted) && Math.abs(sum - 1) > WHOLE;
    return {
      model: {
        ...withPositions(skin.model, blended.positions),
        ...blendedMorphs(skins, names, blended.weights),
        ...blendedRig(skins[names[0]!]!, blended.positions),
      },
      figures: {
        weights: Object.fromEntries(names.map((name, at) => [name, blended.weights[at]!])),
        measures: step.measures.map((measure, at) => reachedOf(measure, blended, at)),
        iterations: blended.iterations,
      },
      seconds: { ...prepared.seconds, ...blended.seconds },
      peakBytes: prepared.peakBytes,
      warnings: [...(loose ? [notWhole] : []), ...prepared.warnings, ...blended.warnings],
    };
  },

  questions: {
    /** By model: each of some measures, of its skin. What sliders go from and to. */
    async measures(step, context, measures): Promise<Record<string, number[]>> {
      const { names } = given(step, context);
      const prepared = await prepareBlend(step, context);
      const found: Record<string, number[]> = {};
      for (const [at, name] of names.entries()) {
        const weights = Float64Array.from(names, (_, other) => (other === at ? 1 : 0));
        const specs = measures.map((measure) => ({ ...specOf(measure), value: undefined }));
        const args = { blend: prepared.id, weights, measures: specs };
        found[name] = [...(await context.kernel.call('blend', args, signalOf(context))).reached];
      }
      return found;
    },
  } satisfies Record<
    string,
    (step: BlendStep, context: StepContext, measures: readonly BlendMeasure[]) => Promise<unknown>
  >,
} satisfies StepRunner<BlendStep>;

/** The skins that the match left, in its order. */
function given(step: BlendStep, { inputs, origins }: StepContext) {
  const [skin] = inputs as [ModelResult];
  const skins: Readonly<Record<string, Model>> = origins[0]!.models!;
  const names = Object.keys(skins);
  return { skin, skins, names, weights: Float64Array.from(names, (name) => step.weights[name] ?? 0) };
}

/** Σ weight · morph: the skins of a match have the same ones. */
function blendedMorphs(
  skins: Readonly<Record<string, Model>>,
  names: readonly string[],
  weights: Float64Array,
): Pick<Model, 'morphs'> {
  const first = skins[names[0]!]!.morphs;
  if (!first) return {};
  const morphs = first.map(({ name, offsets }, number) => {
    const sum = new Float32Array(offsets.length);
    for (const [k, skin] of names.entries()) {
      const own = skins[skin]!.morphs![number]!.offsets;
      for (let at = 0; at < sum.length; at++) sum[at]! += weights[k]! * own[at]!;
    }
    return { name, offsets: sum };
  });
  return { morphs };
}

/** Joints go where they would on a skin of that shape. */
const blendedRig = (
  { rig, faceVertices, positions: from }: Model,
  positions: Float64Array,
): Pick<Model, 'rig'> => (rig ? { rig: carriedRig(rig, faceVertices, from, positions) } : {});

function prepareBlend(step: BlendStep, context: StepContext) {
  const { skin, skins, names } = given(step, context);
  const parts = step.parts.map(({ from, vertices, feather, how }) => ({
    from: names.indexOf(from),
    vertices: toIndices(vertices, vertexCount(skin.model)),
    feather,
    how,
  }));
  return context.kernel.hold(
    'prepareBlend',
    hashValue({ skins: skin.key, parts: blendRunner.content(step).parts }),
    { triangles: skin.model.faceVertices, positions: names.map((name) => skins[name]!.positions), parts },
    { ...signalOf(context), onProgress: (fraction) => context.onProgress(0.9 * fraction) },
  );
}

const isWanted = ({ value }: BlendMeasure): boolean => value !== undefined;

function verticesOf(measure: BlendMeasure): readonly number[] {
  if (measure.kind === 'length') return measure.path;
  if (measure.kind === 'girth') return measure.loop ?? [measure.vertex!];
  return [];
}

function specOf(measure: BlendMeasure): MeasureSpec {
  const { kind, value } = measure;
  if (kind === 'height') return { kind, up: measure.up, value };
  if (kind === 'length') return { kind: 'path', vertices: Uint32Array.from(measure.path), value };
  const { loop, vertex, normal, hull } = measure;
  return loop
    ? { kind: 'loop', vertices: Uint32Array.from(loop), hull, value }
    : { kind: 'section', vertex: vertex!, normal, hull, value };
}

function reachedOf({ kind, value }: BlendMeasure, { reached }: Blended, at: number) {
  const is = reached[at]!;
  return value === undefined ? { kind, reached: is } : { kind, reached: is, value, residual: is - value };
}

const notWhole: Finding = { code: 'weights-not-whole', count: 1, examples: [], repaired: false };
