// The hair step: a head is prepared once, a style costs what changed of it, strands are grown from there.

import { LissomError } from '../../core/errors';
import { hashValue } from '../../core/hash';
import { hairColor } from '../../core/melanin';
import { type Model, vertexCount } from '../../core/model';
import type { StrandLook, Strands } from '../../core/strands';
import { toIndices, type VertexSet } from '../../core/vertex-set';
import type { FieldVectors, HairOptions, HairStyle, OpenedHair } from '../../kernel/contract';
import type { HairStep } from '../../recipe/recipe';
import { checkVertices, vertexSetKey } from '../vertex-sets';
import { checkReach } from './hair/reach';
import type { StepContext, StepRunner } from './step-runner';

/** Strands that follow a stroke while it is being drawn: the first of all of them. */
export const PREVIEW_STRANDS = 4000;
/** 0.08 mm on a head 24 cm high: an average hair. */
const THICKNESS = 0.08 / 240;
/** Hairs on a head: fewer strands are drawn thicker, up to twice, for each stands for several. */
const WHOLE_HEAD = 100_000;
const THICKEST = 2;

export const hairRunner: StepRunner<HairStep> = {
  check(step, path, [input]) {
    if (!input) return;
    if (step.scalp) checkVertices(step.scalp, `${path}.scalp`, input);
    for (const [at, { vertices }] of step.length.map.entries())
      checkVertices(vertices, `${path}.length.map[${at}].vertices`, input);
  },

  vertexCount: ([input]) => input?.vertices,

  content: ({ scalp, length, ...step }) => ({
    ...step,
    ...styleOf(step),
    id: undefined,
    scalp: scalp && vertexSetKey(scalp),
    length: { ...length, map: length.map.map(({ vertices, factor }) => [vertexSetKey(vertices), factor]) },
  }),

  async run(step, context) {
    const { model } = context.inputs[0]!;
    const signal = context.signal ? { signal: context.signal } : {};
    const { opened, styled } = await styleHead(step, context);
    const { hair } = opened;
    const count = context.settle ? step.strands.count : Math.min(step.strands.count, PREVIEW_STRANDS);
    const grown = await context.kernel.call(
      'growHair',
      { hair, from: 0, count, options: optionsOf(step, model) },
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
      look: lookOf(step, opened),
    };
    return {
      model,
      strands,
      figures: {
        constraints: styled.constraints,
        grid: opened.grid,
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
};

/** The head ready for hair, with the step's style. */
async function styleHead(step: HairStep, { inputs, kernel, signal: stop, onProgress }: StepContext) {
  const input = inputs[0]!;
  checkReach(step, input.model);
  const signal = stop ? { signal: stop } : {};
  const scalp = scalpOf(step, input.model);
  const { resolution } = step.grid;
  const up = input.model.upAxis ?? 'y';
  const headKey = hashValue({ model: input.key, scalp: scalp.key, resolution, up });
  const opened = await kernel.openHair(
    headKey,
    { model: input.opened.model, scalp: scalp.vertices(), resolution, up },
    { ...signal, onProgress: (fraction) => onProgress(0.3 * fraction) },
  );
  const style = { hair: opened.hair, style: styleArgs(step) };
  const styled = await kernel.styleHair(headKey, hashValue(styleOf(step)), style, signal);
  return { opened, styled };
}

/** What a hair step's strands follow, and the volume they may fill. */
export interface HairField extends FieldVectors, Pick<OpenedHair, 'grid' | 'low' | 'high'> {
  /** What the field was asked for: by the style, then by the scalp. */
  readonly constraints: FieldVectors;
}

export async function hairField(step: HairStep, context: StepContext, stride: number): Promise<HairField> {
  const { opened } = await styleHead(step, context);
  const { grid, low, high, hair } = opened;
  const signal = context.signal ? { signal: context.signal } : {};
  const field = await context.kernel.call('hairField', { hair, stride }, signal);
  const constraints = await context.kernel.call('hairConstraints', { hair }, signal);
  return { grid, low, high, constraints, ...field };
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

/** The step's own scalp, or the one that the model brings. */
function scalpOf(step: HairStep, model: Model): { readonly key: string; vertices(): Uint32Array } {
  if (step.scalp) {
    const set: VertexSet = step.scalp;
    return { key: vertexSetKey(set), vertices: () => toIndices(set, vertexCount(model)) };
  }
  const brought = model.vertexSets?.scalp;
  if (!brought)
    throw new LissomError(
      'scalp-missing',
      `${JSON.stringify(model.name)} has no scalp, so hair does not know where to grow. ` +
        'Paint a scalp on it, or choose a head that brings one.',
    );
  return { key: hashValue([...brought]), vertices: () => brought };
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

const lookOf = ({ material, strands }: HairStep, { headHeight }: OpenedHair): StrandLook => ({
  color: material.color?.toLowerCase() ?? hairColor(material.melanin, material.redness),
  colorVariation: material.colorVariation,
  thickness: material.thickness ?? thicknessOf(strands.count, headHeight),
  taper: material.taper,
});
