// The hair step: a head is prepared once, a style costs what changed of it, strands are grown from there.

import { LissomError } from '../../core/errors';
import { hashValue } from '../../core/hash';
import { hairColor } from '../../core/melanin';
import { type Model, vertexCount } from '../../core/model';
import type { StrandLook, Strands } from '../../core/strands';
import { toIndices } from '../../core/vertex-set';
import type { FieldVectors, HairOptions, HairStyle, OpenedHair } from '../../kernel/contract/hair';
import { type HairStep, newHairStep } from '../../recipe/steps/hair';
import { checkVertices, vertexSetKey } from '../vertex-sets';
import { checkReach } from './hair/reach';
import { scalpOf } from './hair/scalp';
import { type StepContext, type StepOutcome, type StepRunner, signalOf } from './step-runner';

/** Strands that follow a stroke while it is being drawn: the first of all of them. */
export const PREVIEW_STRANDS = 4000;
/** 0.08 mm on a head 24 cm high: an average hair. */
const THICKNESS = 0.08 / 240;
/** Hairs on a head: fewer strands are drawn thicker, up to twice, for each stands for several. */
const WHOLE_HEAD = 100_000;
const THICKEST = 2;

export interface HairFigures {
  readonly constraints: number;
  readonly grid: readonly [number, number, number];
  /** What the sizes of hair are measured by, in model units. */
  readonly headHeight: number;
  readonly strands: number;
  readonly insideHead: number;
  readonly shortStrands: number;
  /** Per ponytail: which share of the strands of its region pass through its first cross-section. */
  readonly gathered: readonly number[];
}

/** What a hair step's strands follow, and the volume they may fill. */
export interface HairField extends FieldVectors, Pick<OpenedHair, 'grid' | 'low' | 'high'> {
  /** What the field was asked for: by the style, then by the scalp. */
  readonly constraints: FieldVectors;
}

export const hairRunner = {
  keeps: { openHair: 2 },

  check(step, path, [input]) {
    if (!input) return;
    if (step.scalp) checkVertices(step.scalp, `${path}.scalp`, input);
    for (const [at, { vertices }] of step.length.map.entries())
      checkVertices(vertices, `${path}.length.map[${at}].vertices`, input);
  },

  vertexCount: ([input]) => input?.vertices,

  content: ({ id: _, material: __, scalp, length, ...step }) => ({
    ...step,
    ...styleOf(step),
    scalp: scalp && vertexSetKey(scalp),
    length: { ...length, map: length.map.map(({ vertices, factor }) => [vertexSetKey(vertices), factor]) },
  }),

  async run(step, context): Promise<StepOutcome<HairFigures>> {
    const { model } = context.inputs[0]!;
    const signal = signalOf(context);
    const { opened, styled } = await styleHead(step, context);
    const count = context.settle ? step.strands.count : Math.min(step.strands.count, PREVIEW_STRANDS);
    const grown = await context.kernel.call(
      'growHair',
      { hair: opened.id, from: 0, count, options: optionsOf(step, model) },
      { ...signal, onProgress: (fraction) => context.onProgress(0.4 + 0.6 * fraction) },
    );
    const { offsets, points, origin, rootUvs, groups } = grown;
    const [x = 0, y = 0, z = 0] = origin;
    const strands: Strands = {
      offsets,
      points,
      origin: [x, y, z],
      rootUvs,
      groups,
      look: lookOf(PLAIN, thicknessOf(step.strands.count, opened.headHeight)),
    };
    return {
      model,
      strands,
      figures: {
        constraints: styled.constraints,
        grid: opened.grid,
        headHeight: opened.headHeight,
        strands: offsets.length - 1,
        insideHead: grown.insideHead,
        shortStrands: grown.shortStrands,
        gathered: grown.gathered.map((passed, tail) =>
          grown.reached[tail] ? passed / grown.reached[tail] : 0,
        ),
      },
      seconds: { ...opened.seconds, ...styled.seconds, ...grown.seconds },
      peakBytes: Math.max(opened.peakBytes, grown.peakBytes),
      warnings: styled.warnings,
    };
  },

  /** The look: strands are grown with the plain one, which has the thickness that suits them. */
  finish(step, outcome): StepOutcome {
    const { strands } = outcome;
    if (!strands) return outcome;
    return { ...outcome, strands: { ...strands, look: lookOf(step.material, strands.look.thickness) } };
  },

  questions: {
    /** The field at every `stride`-th node along each axis, for showing it. */
    async field(
      step: HairStep,
      context: StepContext,
      { stride }: { readonly stride: number },
    ): Promise<HairField> {
      const { opened } = await styleHead(step, context);
      const { grid, low, high, id: hair } = opened;
      const signal = signalOf(context);
      const field = await context.kernel.call('hairField', { hair, stride }, signal);
      const constraints = await context.kernel.call('hairConstraints', { hair }, signal);
      return { grid, low, high, constraints, ...field };
    },
  },
} satisfies StepRunner<HairStep>;

const PLAIN = newHairStep('plain', 'plain').material;

/** The head ready for hair, with the step's style. */
async function styleHead(step: HairStep, { inputs, kernel, signal: stop, onProgress }: StepContext) {
  const input = inputs[0]!;
  checkReach(step, input.model);
  const signal = stop ? { signal: stop } : {};
  const { resolution } = step.grid;
  const up = input.model.upAxis ?? 'y';
  const opened = await kernel.hold(
    'openHair',
    hashValue({ model: input.key, scalp: scalpKey(step, input.model), resolution, up }),
    { model: input.opened.id, scalp: scalpOf(step, input.model), resolution, up },
    { ...signal, onProgress: (fraction) => onProgress(0.3 * fraction) },
  );
  const style = { hair: opened.id, style: styleArgs(step) };
  const styled = await kernel.hold('styleHair', hashValue(styleOf(step)), style, {
    ...signal,
    of: opened.id,
  });
  return { opened, styled };
}

/** @throws LissomError `scalp-missing` */
function scalpKey({ scalp }: HairStep, { name, vertexSets }: Model): string {
  const set = scalp ?? vertexSets?.scalp;
  if (set) return vertexSetKey(set);
  throw new LissomError(
    'scalp-missing',
    `${JSON.stringify(name)} has no scalp, so hair does not know where to grow. ` +
      'Paint a scalp on it, or choose a head that brings one.',
  );
}

/** What the field depends on. Names and hiding are for the eye only. */
const styleOf = ({ streams, partings, ponytails }: Pick<HairStep, 'streams' | 'partings' | 'ponytails'>) => ({
  streams: streams.map(({ points, fade }) => ({ points, fade })),
  partings: partings.map(({ points, tilt, sigma, height }) => ({ points, tilt, sigma, height })),
  ponytails: ponytails.map(({ spine, section, profiles, tightness }) => ({
    spine,
    section,
    profiles,
    tightness,
  })),
});

const flat = (points: readonly (readonly number[])[]): Float64Array => Float64Array.from(points.flat());

function styleArgs(step: HairStep): HairStyle {
  const { streams, partings, ponytails } = styleOf(step);
  return {
    streams: streams.map(({ points, fade }) => ({ points: flat(points), fade })),
    partings: partings.map(({ points, ...parting }) => ({ points: flat(points), ...parting })),
    ponytails: ponytails.map(({ spine, section, profiles, tightness }) => ({
      spine: flat(spine),
      section: flat(section),
      profiles: profiles.map(flat),
      tightness,
    })),
  };
}

function optionsOf({ strands, length, volume, detail }: HairStep, model: Model): HairOptions {
  const { seed, step } = strands;
  return {
    seed,
    step,
    lengthVariation: length.variation,
    ...(length.max !== undefined && { length: length.max }),
    ...(length.map.length > 0 && { lengthMap: lengthFactors(length.map, vertexCount(model)) }),
    ...(volume !== undefined && { volume }),
    clump: detail.clump,
    curl: detail.curl,
    ...(detail.curlLength !== undefined && { curlLength: detail.curlLength }),
    frizz: detail.frizz,
    flyaways: detail.flyaways,
  };
}

/** The factor of the length per vertex; 1 where nothing is painted. */
export function lengthFactors(parts: HairStep['length']['map'], count: number): Float32Array {
  const factors = new Float32Array(count).fill(1);
  for (const { vertices, factor } of parts)
    for (const vertex of toIndices(vertices, count)) factors[vertex] = factor;
  return factors;
}

const thicknessOf = (count: number, headHeight: number): number =>
  THICKNESS * headHeight * Math.min(THICKEST, Math.max(1, Math.sqrt(WHOLE_HEAD / Math.max(1, count))));

const lookOf = (
  { color, melanin, redness, colorVariation, thickness, taper }: HairStep['material'],
  plainThickness: number,
): StrandLook => ({
  color: color?.toLowerCase() ?? hairColor(melanin, redness),
  colorVariation,
  thickness: thickness ?? plainThickness,
  taper,
});
