// Small affine maps: 16 numbers, column-major, last row 0 0 0 1 (as recipes and the kernel hold them).

import { type Affine, IDENTITY, multiply as product } from '../core/affine';
import { cross } from '../core/cross';
import type { Vec3 } from '../view/types';

export { cross, IDENTITY };
export type Mat4 = Affine;

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

export const scaled = (a: Vec3, by: number): Vec3 => [a[0] * by, a[1] * by, a[2] * by];
/** From `a` towards `b`: `a` at 0, `b` at 1. */
export const mix = (a: Vec3, b: Vec3, t: number): Vec3 => [
  a[0] + t * (b[0] - a[0]),
  a[1] + t * (b[1] - a[1]),
  a[2] + t * (b[2] - a[2]),
];
export const norm = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);
export const gap = (a: Vec3, b: Vec3): number => norm(subtract(a, b));

export const translation = ([x, y, z]: Vec3): Mat4 => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

/** `a` after `b`. */
export const multiply = (a: Mat4, b: Mat4): Mat4 => affine(product(a, b));

/** @returns the inverse, or `undefined` where the map flattens space */
export function invert(m: Mat4): Mat4 | undefined {
  const [a, b, c, , d, e, f, , g, h, i] = m as number[] as [...Sixteen];
  const A = e * i - f * h;
  const B = f * g - d * i;
  const C = d * h - e * g;
  const det = a * A + b * B + c * C;
  if (!(Math.abs(det) > 0) || !Number.isFinite(1 / det)) return undefined;
  const linear = [A, c * h - b * i, b * f - c * e, 0, B, a * i - c * g, c * d - a * f, 0].concat([
    C,
    b * g - a * h,
    a * e - b * d,
    0,
  ]);
  const inverse = [...linear.map((x) => x / det), 0, 0, 0, 1];
  const moved = transform(inverse, position(m));
  return affine([...inverse.slice(0, 12), -moved[0], -moved[1], -moved[2], 1]);
}

/** Where the map takes a point. */
export function transform(m: Mat4, [x, y, z]: Vec3): Vec3 {
  return [
    m[0]! * x + m[4]! * y + m[8]! * z + m[12]!,
    m[1]! * x + m[5]! * y + m[9]! * z + m[13]!,
    m[2]! * x + m[6]! * y + m[10]! * z + m[14]!,
  ];
}

/** Where the map takes the origin. */
export const position = (m: Mat4): Vec3 => [m[12]!, m[13]!, m[14]!];

export const isIdentity = (m: Mat4): boolean => m.every((x, i) => x === IDENTITY[i]);

/** A map taken apart: linear part = rotation · scale, then `translation`, all about a pivot. */
export interface Parts {
  readonly translation: Vec3;
  /** Degrees; x first, then y, then z, about fixed axes. */
  readonly rotation: Vec3;
  readonly scale: Vec3;
}

/** x ↦ pivot + translation + R·S·(x − pivot). */
export function compose({ translation: t, rotation, scale }: Parts, pivot: Vec3): Mat4 {
  const r = fromEuler(rotation);
  const linear = r.map((x, i) => (i < 12 ? x * scale[Math.floor(i / 4)]! : x));
  const moved = transform(linear, pivot);
  const to = subtract(add(pivot, t), moved);
  return affine([...linear.slice(0, 12), to[0], to[1], to[2], 1]);
}

/** The inverse of `compose`; exact where the map has no shear, else its nearest reading by columns. */
export function decompose(m: Mat4, pivot: Vec3): Parts {
  const scale = [0, 4, 8].map((k) => Math.hypot(m[k]!, m[k + 1]!, m[k + 2]!)) as [number, number, number];
  if (determinant(m) < 0) scale[0] = -scale[0];
  return { translation: subtract(transform(m, pivot), pivot), rotation: toEuler(rotationOf(m)), scale };
}

/** The rotation in a map: its columns made orthonormal one after the other (Gram-Schmidt), right-handed. */
export function rotationOf(m: Mat4): Mat4 {
  const x = unit([m[0]!, m[1]!, m[2]!], [1, 0, 0]);
  const column: Vec3 = [m[4]!, m[5]!, m[6]!];
  const along = dot(column, x);
  const y = unit(subtract(column, [along * x[0], along * x[1], along * x[2]]), anyNormal(x));
  const mirrored = determinant(m) < 0;
  const x2: Vec3 = mirrored ? [-x[0], -x[1], -x[2]] : x;
  const z = cross(x2, y);
  return [...x2, 0, ...y, 0, ...z, 0, 0, 0, 0, 1];
}

/** Rz · Ry · Rx for angles in degrees. */
export function fromEuler(degrees: Vec3): Mat4 {
  const [a, b, c] = degrees.map((d) => (d * Math.PI) / 180) as [number, number, number];
  const [ca, sa, cb, sb, cc, sc] = [cosine(a), sine(a), cosine(b), sine(b), cosine(c), sine(c)];
  return [
    ...[cb * cc, cb * sc, -sb, 0],
    ...[sa * sb * cc - ca * sc, sa * sb * sc + ca * cc, sa * cb, 0],
    ...[ca * sb * cc + sa * sc, ca * sb * sc - sa * cc, ca * cb, 0],
    ...[0, 0, 0, 1],
  ];
}

/** Angles in degrees whose `fromEuler` is the rotation `r`; the third is 0 where the first two suffice. */
export function toEuler(r: Mat4): Vec3 {
  const b = Math.asin(Math.min(1, Math.max(-1, -r[2]!)));
  const level = Math.abs(r[2]!) < 1 - 1e-12;
  const a = level ? Math.atan2(r[6]!, r[10]!) : Math.atan2(-r[9]!, r[5]!);
  const c = level ? Math.atan2(r[1]!, r[0]!) : 0;
  return [a, b, c].map((x) => (x * 180) / Math.PI + 0) as unknown as Vec3;
}

/** Mean of the points `vertices` of `positions` (3 per vertex); non-finite ones are left out. */
export function centroid(positions: Float64Array, vertices: Iterable<number>): Vec3 {
  let count = 0;
  const sum: [number, number, number] = [0, 0, 0];
  for (const v of vertices) {
    const point = pointAt(positions, v);
    if (!point.every(Number.isFinite)) continue;
    count++;
    for (let k = 0; k < 3; k++) sum[k]! += (point[k]! - sum[k]!) / count;
  }
  return sum;
}

export const pointAt = (positions: Float64Array, vertex: number): Vec3 => [
  positions[3 * vertex]!,
  positions[3 * vertex + 1]!,
  positions[3 * vertex + 2]!,
];

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

type Sixteen = [
  ...[number, number, number, number, number, number, number, number],
  ...[number, number, number, number, number, number, number, number],
];

const determinant = (m: Mat4): number =>
  dot([m[0]!, m[1]!, m[2]!], cross([m[4]!, m[5]!, m[6]!], [m[8]!, m[9]!, m[10]!]));

/** The last row exactly 0 0 0 1 and no −0, as the schema and the link want it. */
function affine(m: readonly number[]): Mat4 {
  const out = m.map((x) => x + 0);
  [out[3], out[7], out[11], out[15]] = [0, 0, 0, 1];
  return out;
}

/** The direction of `v`, or `otherwise` where it has none. */
export function unit(v: Vec3, otherwise: Vec3 = [0, 0, 0]): Vec3 {
  const length = norm(v);
  return length > 0 ? [v[0] / length, v[1] / length, v[2] / length] : otherwise;
}

/** Some direction across `v`. */
export const anyNormal = (v: Vec3): Vec3 =>
  unit(cross(v, Math.abs(v[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]), [0, 1, 0]);

/** Quarter turns come out exact, so that 90 degrees typed in leave no crumbs in the recipe. */
const sine = (a: number): number => snap(Math.sin(a));
const cosine = (a: number): number => snap(Math.cos(a));
const snap = (x: number): number => (Math.abs(x - Math.round(x)) < 1e-15 ? Math.round(x) : x);
