// Where skins lie poorly: off their model, or where the model goes on without them. Good places for another marker.

import type { Skin } from '../../view/match/types';
import { diagonalOf } from './size';

export interface PoorPlace {
  /** Number of the model. */
  readonly model: number;
  /** The skins' vertex there, or the nearest to it. */
  readonly vertex: number;
  /** In shares of the model's size. */
  readonly distance: number;
}

/** Shares of a model's size: nearer ones are good enough; two places are this far apart. */
const WORTH = 0.004;
const APART = 0.12;
const MOST = 5;
/** Vertices that are looked at: parts that a skin misses are large. */
const OF_MODEL = 1500;
const OF_SKIN = 6000;

/**
 * @param models  3 numbers per vertex of each
 * @param residuals  of each skin: how far each vertex lies from the model, in shares of its size
 * @returns the poorest first
 */
export function poorPlaces(
  models: readonly Float64Array[],
  skins: readonly Skin[],
  residuals: readonly Float32Array[],
): PoorPlace[] {
  const found = skins.flatMap(({ positions, triangles }, model) => {
    const size = diagonalOf(models[model]!);
    const off = [...residuals[model]!].flatMap((distance, vertex) =>
      distance > WORTH ? [{ model, vertex, distance }] : [],
    );
    const missed = missedPlaces(models[model]!, positions, meanEdge(positions, triangles), size).map(
      ({ vertex, distance }) => ({ model, vertex, distance }),
    );
    return apart([...off, ...missed], positions, APART * size);
  });
  return found.sort((a, b) => b.distance - a.distance).slice(0, MOST);
}

/** The worst of some places, no two of them near each other. */
function apart(places: PoorPlace[], positions: Float64Array, least: number): PoorPlace[] {
  const kept: PoorPlace[] = [];
  for (const place of places.sort((a, b) => b.distance - a.distance)) {
    if (kept.length === MOST) break;
    if (kept.every(({ vertex }) => gapOf(positions, vertex, positions, place.vertex) > least))
      kept.push(place);
  }
  return kept;
}

/** Places of a model that its skin is far from, by the nearest vertex; the room between vertices is no distance. */
function missedPlaces(model: Float64Array, skin: Float64Array, edge: number, size: number) {
  const step = Math.max(1, Math.ceil(model.length / 3 / OF_MODEL));
  const stride = Math.max(1, Math.ceil(skin.length / 3 / OF_SKIN));
  const between = edge * Math.sqrt(stride);
  const found: { readonly vertex: number; readonly distance: number }[] = [];
  for (let v = 0; v < model.length / 3; v += step) {
    let vertex = 0;
    let least = Number.POSITIVE_INFINITY;
    for (let w = 0; w < skin.length / 3; w += stride) {
      const gap = gapOf(model, v, skin, w);
      if (gap < least) [vertex, least] = [w, gap];
    }
    const distance = (least - between) / size;
    if (distance > WORTH && Number.isFinite(distance)) found.push({ vertex, distance });
  }
  return found;
}

function meanEdge(positions: Float64Array, triangles: Uint32Array): number {
  let sum = 0;
  for (let t = 0; t < triangles.length; t += 3)
    for (let k = 0; k < 3; k++)
      sum += gapOf(positions, triangles[t + k]!, positions, triangles[t + ((k + 1) % 3)]!);
  return triangles.length > 0 ? sum / triangles.length : 0;
}

const gapOf = (a: Float64Array, i: number, b: Float64Array, j: number): number =>
  Math.hypot(a[3 * i]! - b[3 * j]!, a[3 * i + 1]! - b[3 * j + 1]!, a[3 * i + 2]! - b[3 * j + 2]!);
