// What a match left, in the order of its models: skins, how good they are, where they are poorest.

import type { Finding } from '../../core/errors';
import type { Model } from '../../core/model';
import type { MatchStep } from '../../recipe/recipe';
import { outputName, producedNames } from '../../recipe/references';
import type { ReportOf, StepResult } from '../../run/results';
import { matchQuality } from '../../run/steps/match';
import type { Skin } from '../../view/match/types';

/** One skin. Distances are shares of its model's diagonal. */
export interface SkinQuality {
  readonly mean: number;
  readonly p99: number;
  readonly folds: number;
  readonly crossings: number;
  readonly flipped: number;
  /** Sharp edges of the model that it has no edges along. */
  readonly sharp: number;
}

/** Where a skin lies poorly: a good place for another marker. */
export interface PoorPlace {
  /** Number of the model. */
  readonly model: number;
  /** The skins' vertex. */
  readonly vertex: number;
  /** In shares of the model's size. */
  readonly distance: number;
}

export interface Matching {
  /** The step as it was matched. */
  readonly of: MatchStep;
  readonly triangles: Uint32Array;
  readonly skins: readonly Skin[];
  /** The same, as models to go on with. */
  readonly models: readonly Model[];
  readonly quality: readonly SkinQuality[];
  /** Per skin and vertex. */
  readonly residuals: readonly Float32Array[];
  /** The poorest first. */
  readonly poor: readonly PoorPlace[];
  readonly markerError: number;
  readonly seconds: number;
  readonly warnings: readonly Finding[];
}

/** Nearer ones are good enough; shares of the model's size. */
const WORTH = 0.004;
const MOST_POOR = 5;

export function matchingOf(of: MatchStep, result: StepResult): Matching | null {
  const report = result.report as ReportOf<'match'>;
  const known = matchQuality(result.model);
  const { models: left } = result;
  if (!known || !left) return null;
  const names = producedNames(of).map((name) => outputName(of, name));
  const models = names.map((name) => left[name]!);
  const { faceVertices: triangles } = result.model;
  const residuals = names.map((name) => known.residuals[name]!);
  const skins = models.map(({ positions }) => ({ triangles, positions }));
  return {
    of,
    triangles,
    models,
    skins,
    quality: names.map((name) => ({
      mean: Math.max(report.distance[name]!.mean, report.distance[name]!.back),
      p99: report.distance[name]!.p99,
      folds: report.folds[name]!,
      crossings: report.selfIntersections[name]!,
      flipped: report.flipped[name]!,
      sharp: report.sharp[name]?.failed ?? 0,
    })),
    residuals,
    poor: names
      .flatMap((name, model) =>
        [...known.poorest[name]!].map((vertex) => ({
          model,
          vertex,
          distance: residuals[model]![vertex]!,
        })),
      )
      .filter(({ distance }) => distance > WORTH)
      .sort((a, b) => b.distance - a.distance)
      .slice(0, MOST_POOR),
    markerError: report.markerError,
    seconds: Object.values(report.seconds).reduce((sum, each) => sum + each, 0),
    warnings: report.warnings,
  };
}

/** The heat map's upper end: what all but the poorest of all skins' vertices are nearer than. */
export function heatTop({ residuals }: Matching): number {
  const sorted = residuals.map((each) => Float32Array.from(each).sort());
  const high = sorted.map((each) => each[Math.floor(0.995 * (each.length - 1))] ?? 0);
  return Math.max(LEAST_TOP, ...high);
}

/** Of smaller differences no colour makes a fuss. */
const LEAST_TOP = 0.002;
