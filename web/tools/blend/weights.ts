// Weights of a blend as people move them: by a dot in a triangle, or one by one with the others making room. Pure.

/** By model. */
export type Weights = Readonly<Record<string, number>>;

/** In a plane, y down. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** Three models, one at each corner. */
export type Three = readonly [string, string, string];

export const sumOf = (weights: Weights): number =>
  Object.values(weights).reduce((sum, weight) => sum + weight, 0);

/** Numbers short enough to be read and sent. */
const DIGITS = 4;
export const rounded = (weight: number): number => Number(weight.toFixed(DIGITS)) + 0;

/**
 * One weight set, the others sharing what is left of 1 as they did before: as much of each where they were nothing.
 * @param names  of all models, in their order
 */
export function sharing(weights: Weights, names: readonly string[], name: string, value: number): Weights {
  const others = names.filter((other) => other !== name);
  const before = others.reduce((sum, other) => sum + (weights[other] ?? 0), 0);
  const left = 1 - value;
  const share = (other: string): number =>
    Math.abs(before) > 1e-9 ? ((weights[other] ?? 0) / before) * left : left / others.length;
  return whole(Object.fromEntries(names.map((each) => [each, each === name ? value : share(each)])), name);
}

/** All weights scaled so that they make a whole; as much of each where they sum to nothing. */
export function normalised(weights: Weights, names: readonly string[]): Weights {
  const sum = names.reduce((all, name) => all + (weights[name] ?? 0), 0);
  const scaled = names.map((name) => [
    name,
    Math.abs(sum) > 1e-9 ? (weights[name] ?? 0) / sum : 1 / names.length,
  ]);
  return whole(Object.fromEntries(scaled));
}

/** Rounded weights that still sum to 1: the largest of them, or of all but `kept`, takes up what rounding left. */
function whole(weights: Weights, kept?: string): Weights {
  const out = Object.fromEntries(Object.entries(weights).map(([name, weight]) => [name, rounded(weight)]));
  const names = Object.keys(out).filter((name) => name !== kept);
  const largest = names.reduce<string | undefined>(
    (best, name) => (best === undefined || out[name]! > out[best]! ? name : best),
    undefined,
  );
  if (largest !== undefined) out[largest] = rounded(out[largest]! + 1 - sumOf(out));
  return out;
}

/** Barycentric coordinates of a point; the point is first brought into the triangle. */
export function sharesAt(corners: readonly [Point, Point, Point], point: Point): [number, number, number] {
  const [a, b, c] = corners;
  const area = cross(a, b, c);
  const at = area === 0 ? [1, 0, 0] : [cross(point, b, c) / area, cross(a, point, c) / area, 0];
  at[2] = 1 - at[0]! - at[1]!;
  if (at.every((share) => share >= 0)) return at as [number, number, number];
  return nearest(corners, point);
}

/** Where the dot is; weights beyond the triangle are shown on its edge. */
export function placeOf(
  corners: readonly [Point, Point, Point],
  shares: readonly [number, number, number],
): Point {
  const positive = shares.map((share) => Math.max(0, share));
  const sum = positive.reduce((all, share) => all + share, 0);
  const parts = sum > 0 ? positive.map((share) => share / sum) : [1 / 3, 1 / 3, 1 / 3];
  return {
    x: corners.reduce((x, corner, k) => x + parts[k]! * corner.x, 0),
    y: corners.reduce((y, corner, k) => y + parts[k]! * corner.y, 0),
  };
}

/** Three weights by shares of what the others leave of 1. */
export function withShares(
  weights: Weights,
  names: readonly string[],
  three: Three,
  shares: readonly [number, number, number],
): Weights {
  const others = names.filter((name) => !three.includes(name));
  const left = 1 - others.reduce((sum, name) => sum + (weights[name] ?? 0), 0);
  const set = Object.fromEntries(three.map((name, k) => [name, left * shares[k]!]));
  return whole({ ...Object.fromEntries(names.map((name) => [name, weights[name] ?? 0])), ...set });
}

const cross = (a: Point, b: Point, c: Point): number => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);

function nearest([a, b, c]: readonly [Point, Point, Point], p: Point): [number, number, number] {
  const onEdge = (from: Point, to: Point): { readonly t: number; readonly far: number } => {
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    const length = dx * dx + dy * dy;
    const t = length > 0 ? Math.min(1, Math.max(0, ((p.x - from.x) * dx + (p.y - from.y) * dy) / length)) : 0;
    return { t, far: Math.hypot(p.x - from.x - t * dx, p.y - from.y - t * dy) };
  };
  const edges = [onEdge(a, b), onEdge(b, c), onEdge(c, a)];
  const best = edges.reduce((least, edge, k) => (edge.far < edges[least]!.far ? k : least), 0);
  const shares: [number, number, number] = [0, 0, 0];
  shares[best] = 1 - edges[best]!.t;
  shares[(best + 1) % 3] = edges[best]!.t;
  return shares;
}
