// Where a plane cuts a surface around one of its vertices: the loop that a tape would lie along. Pure.

import { cross, dot, unit } from '../geometry';

export type Direction = readonly [number, number, number];

/**
 * The closed line in which the plane through a vertex cuts the surface, of several the one nearest to that vertex.
 *
 * @param positions  3 per vertex
 * @param triangles  3 vertices each
 * @param normal     of the plane; any length but 0
 * @returns 3 per point, the last joined to the first; `null` where the cut is not closed
 */
export function sectionLoop(
  positions: Float64Array,
  triangles: Uint32Array,
  vertex: number,
  normal: Direction,
): Float64Array | null {
  const along = (v: number): number =>
    normal[0] * positions[3 * v]! + normal[1] * positions[3 * v + 1]! + normal[2] * positions[3 * v + 2]!;
  const height = along(vertex);
  // A vertex in the plane counts as above it, so every triangle is cut in two edges or in none.
  const above = (v: number): boolean => along(v) >= height;
  const next = new Map<number, number>();
  const count = positions.length / 3;
  const edge = (a: number, b: number): number => (a < b ? a * count + b : b * count + a);
  for (let t = 0; t < triangles.length; t += 3)
    for (let c = 0; c < 3; c++) {
      const [a, b, d] = [triangles[t + c]!, triangles[t + ((c + 1) % 3)]!, triangles[t + ((c + 2) % 3)]!];
      // Out of the half above by one edge, back by the other: each way round is the same for all triangles.
      if (above(a) && !above(b)) next.set(edge(a, b), above(d) ? edge(b, d) : edge(d, a));
    }
  // Left are the loops; each starts where no other has been.
  const loops: Float64Array[] = [];
  const done = new Set<number>();
  for (const start of next.keys()) {
    if (done.has(start)) continue;
    const line: number[] = [];
    let at: number | undefined = start;
    while (at !== undefined && !done.has(at)) {
      done.add(at);
      line.push(...crossing(positions, at, count, along, height));
      at = next.get(at);
    }
    if (at === start) loops.push(Float64Array.from(line));
  }
  const far = (loop: Float64Array): number =>
    distanceTo(loop, positions.subarray(3 * vertex, 3 * vertex + 3));
  return loops.reduce<Float64Array | null>(
    (best, loop) => (best === null || far(loop) < far(best) ? loop : best),
    null,
  );
}

function crossing(
  positions: Float64Array,
  edge: number,
  count: number,
  along: (v: number) => number,
  height: number,
): [number, number, number] {
  const [a, b] = [Math.floor(edge / count), edge % count];
  const [from, to] = [along(a), along(b)];
  const t = to === from ? 0 : Math.min(1, Math.max(0, (height - from) / (to - from)));
  const at = (k: number): number =>
    positions[3 * a + k]! + t * (positions[3 * b + k]! - positions[3 * a + k]!);
  return [at(0), at(1), at(2)];
}

function distanceTo(loop: Float64Array, point: Float64Array): number {
  let least = Infinity;
  for (let i = 0; i < loop.length; i += 3)
    least = Math.min(
      least,
      Math.hypot(loop[i]! - point[0]!, loop[i + 1]! - point[1]!, loop[i + 2]! - point[2]!),
    );
  return least;
}

/** Length of a closed line. */
export function loopLength(loop: Float64Array): number {
  let sum = 0;
  for (let i = 0; i < loop.length; i += 3) {
    const j = (i + 3) % loop.length;
    sum += Math.hypot(loop[j]! - loop[i]!, loop[j + 1]! - loop[i + 1]!, loop[j + 2]! - loop[i + 2]!);
  }
  return sum;
}

/** Length of the convex hull's edge of a closed line in a plane: how a tape lies over hollows. */
export function hullLength(loop: Float64Array, normal: Direction): number {
  const hull = hullOf(loop, normal);
  return hull.reduce((sum, p, k) => {
    const q = hull[(k + 1) % hull.length]!;
    return sum + Math.hypot(q[0] - p[0], q[1] - p[1]);
  }, 0);
}

/** By Andrew's monotone chain, in a plane's own coordinates. */
function hullOf(loop: Float64Array, normal: Direction): (readonly [number, number])[] {
  const n = unit(normal);
  const least = n.reduce((best, x, k) => (Math.abs(x) < Math.abs(n[best]!) ? k : best), 0);
  const axis = [0, 1, 2].map((k) => (k === least ? 1 : 0)) as [number, number, number];
  const u = unit(cross(n, axis));
  const v = cross(n, u);
  const flat = Array.from({ length: loop.length / 3 }, (_, i): readonly [number, number] => {
    const p: Direction = [loop[3 * i]!, loop[3 * i + 1]!, loop[3 * i + 2]!];
    return [dot(p, u), dot(p, v)];
  }).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const turn = (a: readonly [number, number], b: readonly [number, number], c: readonly [number, number]) =>
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const chain = (points: readonly (readonly [number, number])[]) => {
    const out: (readonly [number, number])[] = [];
    for (const p of points) {
      while (out.length > 1 && turn(out.at(-2)!, out.at(-1)!, p) <= 0) out.pop();
      out.push(p);
    }
    return out.slice(0, -1);
  };
  return [...chain(flat), ...chain([...flat].reverse())];
}
