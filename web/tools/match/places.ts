// Places on a model as recipes hold them, and the way from a point in space to one.

import { roundTo } from '../../core/decimal';
import type { Model } from '../../core/model';
import type { OpenedModel } from '../../kernel/contract/model';
import type { MarkerPlace } from '../../recipe/steps/match';
import { placePoint } from '../../run/steps/match/places';
import type { Hit, Vec3 } from '../../view/types';
import { add, dot, gap, pointAt, scaled, subtract } from '../geometry';

/** A model and the triangles that it is drawn by. */
export interface Surface {
  readonly model: Model;
  readonly opened: Pick<OpenedModel, 'triangles' | 'faceOfTriangle'>;
}

/** Somewhere on a model. */
export interface Spot {
  readonly place: MarkerPlace;
  readonly point: Vec3;
}

/** Of weights: a marker may lie a ten-thousandth of a triangle beside the pointer. */
const DECIMALS = 4;

/** Where a place is; `null` where the model has no such place. */
export function pointOf({ model }: Pick<Surface, 'model'>, place: MarkerPlace): Vec3 | null {
  try {
    const point = placePoint(model, place, model.name);
    return point.every(Number.isFinite) ? point : null;
  } catch {
    return null;
  }
}

export const spotAt = (surface: Surface, { triangle, vertex, point }: Hit): Spot =>
  spotIn(surface, triangle, point) ?? { place: vertex, point: pointAt(surface.model.positions, vertex) };

/** The place of the surface nearest to a point, and how far off it is. */
export function nearestSpot(
  surface: Surface,
  to: Vec3,
): { readonly spot: Spot; readonly distance: number } | null {
  const { positions } = surface.model;
  const { triangles } = surface.opened;
  let best = -1;
  let nearest: Vec3 = to;
  let least = Number.POSITIVE_INFINITY;
  for (let t = 0; 3 * t < triangles.length; t++) {
    const point = nearestOnTriangle(
      pointAt(positions, triangles[3 * t]!),
      pointAt(positions, triangles[3 * t + 1]!),
      pointAt(positions, triangles[3 * t + 2]!),
      to,
    );
    const distance = gap(point, to);
    if (!(distance < least)) continue;
    [best, nearest, least] = [t, point, distance];
  }
  const spot = best < 0 ? null : spotIn(surface, best, nearest);
  return spot && { spot, distance: least };
}

/** By weights of a triangle's corners in the face that it is of; `null` where it is none. */
function spotIn({ model, opened }: Surface, triangle: number, point: Vec3): Spot | null {
  const face = opened.faceOfTriangle[triangle];
  if (face === undefined) return null;
  const corners = [...opened.triangles.subarray(3 * triangle, 3 * triangle + 3)];
  const [a, b, c] = corners.map((v) => pointAt(model.positions, v)) as [Vec3, Vec3, Vec3];
  const weights = weightsIn(a, b, c, point);
  const ring = model.faceVertices.subarray(model.faceOffsets[face], model.faceOffsets[face + 1]);
  const at = new Array<number>(ring.length).fill(0);
  for (const [k, vertex] of corners.entries()) {
    const corner = ring.indexOf(vertex);
    if (corner < 0) return null;
    at[corner] = at[corner]! + weights[k]!;
  }
  const place = { face, at };
  return { place, point: placePoint(model, place, model.name) };
}

/** Rounded, and still 1 together. */
function weightsIn(a: Vec3, b: Vec3, c: Vec3, point: Vec3): [number, number, number] {
  const [e, f, to] = [subtract(b, a), subtract(c, a), subtract(point, a)];
  const [ee, ef, ff] = [dot(e, e), dot(e, f), dot(f, f)];
  const area = ee * ff - ef * ef;
  if (!(area > 0)) return [1, 0, 0];
  const within = (x: number) => roundTo(Math.min(1, Math.max(0, x)), DECIMALS);
  const u = within((ff * dot(to, e) - ef * dot(to, f)) / area);
  const v = Math.min(within((ee * dot(to, f) - ef * dot(to, e)) / area), roundTo(1 - u, DECIMALS));
  return [roundTo(1 - u - v, DECIMALS), u, v];
}

/** By the regions of a triangle's plane (C. Ericson, Real-Time Collision Detection, 2005, 5.1.5). */
export function nearestOnTriangle(a: Vec3, b: Vec3, c: Vec3, p: Vec3): Vec3 {
  const [ab, ac, ap] = [subtract(b, a), subtract(c, a), subtract(p, a)];
  const [d1, d2] = [dot(ab, ap), dot(ac, ap)];
  if (d1 <= 0 && d2 <= 0) return a;
  const bp = subtract(p, b);
  const [d3, d4] = [dot(ab, bp), dot(ac, bp)];
  if (d3 >= 0 && d4 <= d3) return b;
  const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return add(a, scaled(ab, d1 / (d1 - d3)));
  const cp = subtract(p, c);
  const [d5, d6] = [dot(ab, cp), dot(ac, cp)];
  if (d6 >= 0 && d5 <= d6) return c;
  const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return add(a, scaled(ac, d2 / (d2 - d6)));
  const va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return add(b, scaled(subtract(c, b), (d4 - d3) / (d4 - d3 + d5 - d6)));
  const whole = va + vb + vc;
  if (!(whole > 0)) return a;
  return add(a, add(scaled(ab, vb / whole), scaled(ac, vc / whole)));
}
