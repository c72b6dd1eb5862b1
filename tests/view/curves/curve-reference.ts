// A pose vertex by vertex, as the kernel's header writes it: what the kernel and the graphics card are both held to.

import type { CurveAttributes } from '../../../web/kernel/contract/curve';

type Vector = readonly [number, number, number];
/** Rows of three numbers. */
type Matrix = readonly [Vector, Vector, Vector];
type Four = readonly [number, number, number, number];

const AXES = [0, 1, 2] as const;
const dot = (a: readonly number[], b: readonly number[]): number =>
  a.reduce((sum, x, k) => sum + x * b[k]!, 0);
const cross = (a: readonly number[], b: readonly number[]): Vector => [
  a[1]! * b[2]! - a[2]! * b[1]!,
  a[2]! * b[0]! - a[0]! * b[2]!,
  a[0]! * b[1]! - a[1]! * b[0]!,
];
const vector = (of: (k: 0 | 1 | 2) => number): Vector => [of(0), of(1), of(2)];
const matrix = (of: (row: number, column: number) => number): Matrix =>
  vector((row) => row).map((row) => vector((column) => of(row, column))) as unknown as Matrix;
const plus = (a: Matrix, b: Matrix): Matrix => matrix((i, j) => a[i]![j]! + b[i]![j]!);
const times = (s: number, a: Matrix): Matrix => matrix((i, j) => s * a[i]![j]!);
const after = (a: Matrix, b: Matrix): Matrix =>
  matrix((i, j) => AXES.reduce<number>((sum, k) => sum + a[i]![k]! * b[k]![j]!, 0));
const outer = (a: Vector, b: Vector): Matrix => matrix((i, j) => a[i]! * b[j]!);
const IDENTITY = matrix((i, j) => Number(i === j));

/** An affine map: lines of its matrix, and a shift. */
interface Affine {
  readonly turn: Matrix;
  readonly shift: Vector;
}
const applied = ({ turn, shift }: Affine, x: Vector): Vector => vector((k) => dot(turn[k], x) + shift[k]);

/** A sum of dual quaternions as a motion. */
function motion(real: readonly number[], dual: readonly number[]): Affine {
  const norm = Math.hypot(...real);
  const [r, d] = [real.map((x) => x / norm), dual.map((x) => x / norm)];
  const [a, b] = [r.slice(0, 3), d.slice(0, 3)];
  const column = (j: number): Vector => {
    const e = vector((k) => Number(k === j));
    const inner = vector((k) => cross(a, e)[k] + r[3]! * e[k]);
    return vector((k) => e[k] + 2 * cross(a, inner)[k]);
  };
  return {
    turn: matrix((i, j) => column(j)[i]!),
    shift: vector((k) => 2 * (r[3]! * b[k]! - d[3]! * a[k]! + cross(a, b)[k])),
  };
}

/**
 * @param gradientOf  how the row of a vertex's curve changes with its place, where it is known; else from `slopes`
 * @returns 3 numbers a vertex, and normals that are turned along
 */
export function posed(
  { curves, rows, weights, centre, slopes }: Omit<CurveAttributes, 'frames'>,
  texels: ArrayLike<number>,
  rest: ArrayLike<number>,
  normals: ArrayLike<number>,
  gradientOf?: (vertex: number, slot: number) => ArrayLike<number>,
): { readonly positions: Float64Array; readonly normals: Float64Array } {
  const count = rest.length / 3;
  const out = { positions: new Float64Array(3 * count), normals: new Float64Array(3 * count) };
  for (let v = 0; v < count; v++) {
    const x = vector((k) => rest[3 * v + k]! - centre[k]);
    const parts = [0, 1, 2, 3]
      .map((slot) => ({
        slot,
        weight: weights[4 * v + slot]!,
        curve: curves[4 * v + slot]!,
        row: rows[4 * v + slot]!,
      }))
      .filter(({ weight }) => weight !== 0)
      .map(({ slot, weight, curve, row }) => {
        const first = Math.min(Math.floor(row), 254);
        const share = row - first;
        const texel = (next: number, t: number): Four => {
          const at = 20 * (256 * curve + first + next) + 4 * t;
          return [texels[at]!, texels[at + 1]!, texels[at + 2]!, texels[at + 3]!];
        };
        const mixed = (t: number) => texel(0, t).map((a, c) => (1 - share) * a + share * texel(1, t)[c]!);
        const before = (t: (k: number) => readonly number[]): Affine => ({
          turn: matrix((i, j) => t(2 + i)[j]!),
          shift: vector((k) => t(2 + k)[3]!),
        });
        const whole = (next: number): Affine => {
          const [outside, inside] = [motion(texel(next, 0), texel(next, 1)), before((t) => texel(next, t))];
          return { turn: after(outside.turn, inside.turn), shift: applied(outside, inside.shift) };
        };
        const [low, high] = [whole(0), whole(1)];
        const from = applied(low, x);
        const to = applied(high, x);
        const slope = (part: number): Vector =>
          vector((k) => {
            const at = 9 * (256 * curve + first) + 3 * part + k;
            return (1 - share) * slopes[at]! + share * slopes[at + 9]!;
          });
        const bend = dot(
          slope(2),
          vector((k) => x[k] - slope(0)[k]),
        );
        const inside = row > 0 && row < 255;
        const known = gradientOf?.(v, slot);
        const gradient = vector((k) =>
          known ? known[k]! : inside ? slope(1)[k] / Math.max(1 - bend, 0.05) : 0,
        );
        const change = outer(
          vector((k) => to[k] - from[k]),
          gradient,
        );
        return {
          weight,
          share,
          real: mixed(0),
          dual: mixed(1),
          before: before(mixed),
          low,
          high,
          from,
          to,
          change,
        };
      });
    const only = parts.find(({ weight }) => weight === 1);
    let place: Vector;
    let turn: Matrix;
    if (only) {
      const { share, from, to, low, high, change } = only;
      place = vector((k) => (1 - share) * from[k] + share * to[k]);
      turn = plus(plus(times(1 - share, low.turn), times(share, high.turn)), change);
    } else {
      const left = 1 - parts.reduce((sum, { weight }) => sum + weight, 0);
      let [real, dual]: [number[], number[]] = [
        [0, 0, 0, 0],
        [0, 0, 0, 0],
      ];
      for (const part of [...parts, { weight: left, real: [0, 0, 0, 1], dual: [0, 0, 0, 0] }]) {
        const sided = dot(real, part.real) < 0 ? -part.weight : part.weight;
        real = real.map((a, c) => a + sided * part.real[c]!);
        dual = dual.map((a, c) => a + sided * part.dual[c]!);
      }
      const blend = motion(real, dual);
      const point = vector((k) =>
        parts.reduce((sum, p) => sum + p.weight * applied(p.before, x)[k], left * x[k]),
      );
      place = applied(blend, point);
      const inner = parts.reduce(
        (sum, p) => plus(sum, times(p.weight, p.before.turn)),
        times(left, IDENTITY),
      );
      turn = parts.reduce((sum, p) => plus(sum, times(p.weight, p.change)), after(blend.turn, inner));
    }
    const columns = vector((k) => k).map((j) => vector((i) => turn[i]![j]!));
    const cofactors = [
      cross(columns[1]!, columns[2]!),
      cross(columns[2]!, columns[0]!),
      cross(columns[0]!, columns[1]!),
    ];
    const n = vector((k) =>
      AXES.reduce<number>((sum, j) => sum + cofactors[j]![k]! * normals[3 * v + j]!, 0),
    );
    const size = Math.hypot(...n);
    for (const k of AXES) {
      out.positions[3 * v + k] = place[k] + centre[k];
      out.normals[3 * v + k] = size > 0 ? n[k] / size : normals[3 * v + k]!;
    }
  }
  return out;
}
