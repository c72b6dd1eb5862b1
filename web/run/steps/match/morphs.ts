// Morph targets of the source, read off it for its skin, and carried on to the others.

import { cross } from '../../../core/cross';
import type { Morph } from '../../../core/model';
import type { SurfacePlaces } from '../../../kernel/contract/wear';
import type { ModelResult } from '../../types';
import { mixing } from './attributes';

/** Those of a model where its skin's vertices lie on it: mixed by the weights of each place. */
export function readMorphs({ model, opened }: ModelResult, places: SurfacePlaces): readonly Morph[] {
  const mixed = mixing(opened.triangles, places);
  return (model.morphs ?? []).map(({ name, offsets: given }) => {
    const offsets = new Float32Array(3 * places.triangles.length);
    for (let at = 0; at < offsets.length; at++)
      offsets[at] = mixed(Math.floor(at / 3), (source) => given[3 * source + (at % 3)]!);
    return { name, offsets };
  });
}

/**
 * Morphs of one skin on another of the same triangles: each vertex's way is turned and stretched as the surface around it is. That is
 * told by the mean, by area, of the deformation gradients F = [e₁′ e₂′ n′][e₁ e₂ n]⁻¹ of its triangles, n being the cross product of two
 * sides over the root of its length, so that it grows with the triangle (R. Sumner and J. Popović, Deformation Transfer for Triangle
 * Meshes, 2004, Eq 1 to 3).
 *
 * @param from  of the skin that has them, 3 per vertex
 */
export function carriedMorphs(
  morphs: readonly Morph[],
  triangles: Uint32Array,
  from: Float64Array,
  to: Float64Array,
): readonly Morph[] {
  if (morphs.length === 0) return [];
  const gradients = vertexGradients(triangles, from, to);
  return morphs.map(({ name, offsets: given }) => {
    const offsets = new Float32Array(given.length);
    for (let v = 0; 3 * v < given.length; v++)
      for (let row = 0; row < 3; row++)
        for (let column = 0; column < 3; column++)
          offsets[3 * v + row]! += gradients[9 * v + 3 * row + column]! * given[3 * v + column]!;
    return { name, offsets };
  });
}

/** Row by row, 9 numbers each; where all triangles around a vertex are flat the identity. */
function vertexGradients(triangles: Uint32Array, from: Float64Array, to: Float64Array): Float64Array {
  const sums = new Float64Array(3 * from.length);
  const areas = new Float64Array(from.length / 3);
  for (let first = 0; first < triangles.length; first += 3) {
    const before = frame(from, triangles, first);
    const after = frame(to, triangles, first);
    const dual = inverse(before.columns);
    if (!dual) continue;
    for (let corner = 0; corner < 3; corner++) {
      const v = triangles[first + corner]!;
      areas[v]! += before.area;
      for (let row = 0; row < 3; row++)
        for (let column = 0; column < 3; column++)
          for (let k = 0; k < 3; k++)
            sums[9 * v + 3 * row + column]! += before.area * after.columns[k]![row]! * dual[k]![column]!;
    }
  }
  for (let v = 0; v < areas.length; v++)
    for (let k = 0; k < 9; k++)
      sums[9 * v + k] = areas[v]! > 0 ? sums[9 * v + k]! / areas[v]! : Number(k % 4 === 0);
  return sums;
}

type Vector = readonly [number, number, number];

/** Two sides of a triangle and its normal, as long as the triangle is large. */
function frame(positions: Float64Array, triangles: Uint32Array, first: number) {
  const side = (corner: number): Vector => {
    const [a, b] = [3 * triangles[first]!, 3 * triangles[first + corner]!];
    return [
      positions[b]! - positions[a]!,
      positions[b + 1]! - positions[a + 1]!,
      positions[b + 2]! - positions[a + 2]!,
    ];
  };
  const [u, w] = [side(1), side(2)];
  const normal = cross(u, w);
  const twice = Math.hypot(...normal);
  const scale = twice > 0 ? 1 / Math.sqrt(twice) : 0;
  const n: Vector = [normal[0] * scale, normal[1] * scale, normal[2] * scale];
  return { columns: [u, w, n] as const, area: twice / 2 };
}

/** Rows of the inverse of three columns; `null` where they span no space. */
function inverse([a, b, c]: readonly [Vector, Vector, Vector]): readonly [Vector, Vector, Vector] | null {
  const [p, q, r] = [cross(b, c), cross(c, a), cross(a, b)];
  const size = a[0] * p[0] + a[1] * p[1] + a[2] * p[2];
  if (!(Math.abs(size) > 0)) return null;
  const over = (row: Vector): Vector => [row[0] / size, row[1] / size, row[2] / size];
  return [over(p), over(q), over(r)];
}
