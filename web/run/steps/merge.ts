// The merge step: cut and factored once per set of boundaries, then only the keys change.

import { IDENTITY } from '../../core/affine';
import { type Finding, LissomError } from '../../core/errors';
import { hashValue } from '../../core/hash';
import { type Model, vertexCount } from '../../core/model';
import { toIndices } from '../../core/vertex-set';
import type { MapPlacement, Merged, PaintedRegions, RegionMaps } from '../../kernel/contract/merge';
import type { MergeStep } from '../../recipe/steps/merge';
import type { ModelResult } from '../types';
import { checkApart, checkVertices, vertexSetKey } from '../vertex-sets';
import { mergedModel } from './merge/merged-model';
import { type StepContext, type StepOutcome, type StepRunner, signalOf } from './step-runner';

export interface MergeFigures {
  readonly free: number;
  readonly degenerate: number;
  /** Of an optimal boundary: that of the region's edge first, then after each round. */
  readonly energy?: readonly number[];
  readonly placement?: MapPlacement;
  /** Of given boundaries: the keys used for each, found ones included. */
  readonly keys?: readonly (readonly [number, number][])[];
  readonly seamVertices: number;
  readonly eulerCharacteristic: number;
  readonly seam: Omit<Merged['seam'], 'vertices'>;
  readonly sourceTurned: boolean;
}

export const mergeRunner = {
  /** The one whose keys are moved, and the ones to switch back to. */
  keeps: { prepareMerge: 3 },

  check(step, path, [source, target]) {
    const { optimalBoundary } = step;
    if (optimalBoundary && step.boundaries.length > 0)
      throw new LissomError(
        'two-boundaries',
        `${path}: both boundaries and optimalBoundary say where to join the models; keep one of them.`,
      );
    if (optimalBoundary && step.transition)
      throw new LissomError(
        'transition-without-boundaries',
        `${path}: a transition needs boundaries, not an optimalBoundary; remove one of them.`,
      );
    if (optimalBoundary && source) {
      checkVertices(optimalBoundary.sourceRegion, `${path}.optimalBoundary.sourceRegion`, source);
      checkVertices(optimalBoundary.feature, `${path}.optimalBoundary.feature`, source);
    }
    if (optimalBoundary && target)
      checkVertices(optimalBoundary.targetRegion, `${path}.optimalBoundary.targetRegion`, target);
    for (const [at, boundary] of step.boundaries.entries()) {
      const place = `${path}.boundaries[${at}]`;
      if (source) {
        checkVertices(boundary.source, `${place}.source`, source);
        checkVertices(boundary.sourceKeep, `${place}.sourceKeep`, source);
        checkVertices(
          boundary.keys.map(([vertex]) => vertex),
          `${place}.keys`,
          source,
        );
      }
      if (target) {
        checkVertices(boundary.target, `${place}.target`, target);
        checkVertices(boundary.targetKeep, `${place}.targetKeep`, target);
        checkVertices(
          boundary.keys.map(([, vertex]) => vertex),
          `${place}.keys`,
          target,
        );
      }
    }
    if (!source) return;
    checkVertices(step.roi, `${path}.roi`, source);
    for (const [at, { vertices }] of step.handles.entries())
      checkVertices(vertices, `${path}.handles[${at}].vertices`, source);
    checkApart(
      step.handles.map(({ vertices }) => vertices),
      `${path}.handles`,
      source,
    );
  },

  vertexCount: () => undefined,

  content: (step) => ({ ...prepared(step), keys: step.boundaries.map(({ keys }) => keys) }),

  async run(step, context): Promise<StepOutcome<MergeFigures>> {
    const [source, target] = sidesOf(context);
    const signal = signalOf(context);
    const sources = vertexCount(source.model);
    const targets = vertexCount(target.model);
    const ready = await context.kernel.hold(
      'prepareMerge',
      hashValue({ source: source.key, target: target.key, ...prepared(step) }),
      {
        source: source.opened.id,
        target: target.opened.id,
        boundaries: step.boundaries.map((boundary) => ({
          source: Uint32Array.from(boundary.source),
          target: Uint32Array.from(boundary.target),
          sourceKeep: toIndices(boundary.sourceKeep, sources),
          targetKeep: toIndices(boundary.targetKeep, targets),
        })),
        ...(step.optimalBoundary
          ? { optimalBoundary: paintedRegions(step.optimalBoundary, sources, targets) }
          : {}),
        roi: step.roi === 'all' ? new Uint32Array() : toIndices(step.roi, sources),
        handles: step.handles.map(({ vertices, matrix }) => ({
          vertices: toIndices(vertices, sources),
          matrix: Float64Array.from(matrix ?? IDENTITY),
        })),
        options: {
          mode: step.mode,
          smoothing: step.smoothing,
          ...(step.transition ? { transition: step.transition } : {}),
          ...(step.pose ? { pose: Float64Array.from(step.pose) } : {}),
        },
      },
      { ...signal, onProgress: (fraction) => context.onProgress(0.9 * fraction) },
    );
    const keys = step.optimalBoundary
      ? [new Uint32Array()]
      : step.boundaries.map((boundary) => Uint32Array.from(boundary.keys.flat()));
    const merged = await context.kernel.call(
      'merge',
      { merge: ready.id, keys, settle: context.settle },
      signal,
    );
    const { vertices, ...dihedrals } = merged.seam;
    return {
      model: mergedModel(target.model, source.model, merged),
      figures: {
        free: ready.free,
        degenerate: ready.degenerate,
        ...(step.optimalBoundary
          ? { energy: [...ready.energies], ...(ready.placement && { placement: ready.placement }) }
          : { keys: merged.keys.map(pairs) }),
        seamVertices: vertices,
        eulerCharacteristic: merged.eulerCharacteristic,
        seam: dihedrals,
        sourceTurned: merged.sourceTurned,
      },
      seconds: { ...ready.seconds, ...merged.seconds },
      peakBytes: ready.peakBytes,
      warnings: [...ready.warnings, ...merged.warnings, ...leftOut([target.model, source.model])],
    };
  },

  questions: {
    /** The plane maps that the optimal boundary is sought in, and the placement found for them. */
    maps({ optimalBoundary }: MergeStep, context: StepContext, _: object): Promise<RegionMaps> {
      const [source, target] = sidesOf(context);
      const { placement: __, ...marks } = optimalBoundary ?? NO_MARKS;
      const args = {
        source: source.opened.id,
        target: target.opened.id,
        regions: paintedRegions(marks, vertexCount(source.model), vertexCount(target.model)),
      };
      return context.kernel.call('mapRegions', args, signalOf(context));
    },

    /** Closed paths around painted vertices of one of the two models, the painted side to their left. */
    loopsAround(
      _: MergeStep,
      context: StepContext,
      { side, vertices }: { readonly side: 'source' | 'target'; readonly vertices: Uint32Array },
    ): Promise<readonly Uint32Array[]> {
      const [source, target] = sidesOf(context);
      const { id } = (side === 'source' ? source : target).opened;
      return context.kernel.call('loopsAround', { model: id, vertices }, signalOf(context));
    },
  },
} satisfies StepRunner<MergeStep>;

const NO_MARKS: NonNullable<MergeStep['optimalBoundary']> = {
  sourceRegion: [],
  feature: [],
  targetRegion: [],
};

/** What a merge cannot put together. */
function leftOut(models: readonly Model[]): Finding[] {
  const { length } = models.filter(({ rig }) => rig);
  return length > 0 ? [{ code: 'rig-left-out', count: length, examples: [], repaired: false }] : [];
}

const sidesOf = ({ inputs }: StepContext) => inputs as [source: ModelResult, target: ModelResult];

const paintedRegions = (
  { sourceRegion, feature, targetRegion, placement, rounds }: NonNullable<MergeStep['optimalBoundary']>,
  sources: number,
  targets: number,
): PaintedRegions => ({
  sourceRegion: toIndices(sourceRegion, sources),
  feature: toIndices(feature, sources),
  targetRegion: toIndices(targetRegion, targets),
  ...(placement ? { placement } : {}),
  ...(rounds === undefined ? {} : { rounds }),
});

/** A list of keys as recipes write them. */
const pairs = (keys: Uint32Array): [number, number][] =>
  Array.from({ length: keys.length / 2 }, (_, i) => [keys[2 * i]!, keys[2 * i + 1]!]);

/** What is cut and factored: everything but the keys. Names are for the eye only. */
const prepared = (step: MergeStep): object => ({
  mode: step.mode,
  boundaries: step.boundaries.map(({ source, target, sourceKeep, targetKeep }) => [
    vertexSetKey(source),
    vertexSetKey(target),
    vertexSetKey(sourceKeep),
    vertexSetKey(targetKeep),
  ]),
  ...(step.optimalBoundary
    ? {
        regions: [
          vertexSetKey(step.optimalBoundary.sourceRegion),
          vertexSetKey(step.optimalBoundary.feature),
          vertexSetKey(step.optimalBoundary.targetRegion),
        ],
        placement: step.optimalBoundary.placement ?? 'best',
        rounds: step.optimalBoundary.rounds ?? 'enough',
      }
    : {}),
  roi: vertexSetKey(step.roi),
  handles: step.handles.map(({ vertices, matrix }) => [vertexSetKey(vertices), matrix ?? IDENTITY]),
  pose: step.pose ?? IDENTITY,
  smoothing: step.smoothing,
  transition: step.transition ?? 'none',
});
