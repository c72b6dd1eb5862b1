// The open edges of a surface as closed loops, and the measure along a loop.

import type { GraphSource } from '../mesh-graph';

/** File vertices in order, closed by itself; the surface (or the part to keep) lies to the left. */
export type Loop = readonly number[];

/**
 * The openings of a surface, longest first (by vertices). Where a vertex is in two openings at once, none of the
 * two is a loop, and both are left out.
 */
export function openLoops({ triangles, welded }: GraphSource): Loop[] {
  const next = new Map<number, number>();
  const vertexOf = new Map<number, number>();
  const pinched = new Set<number>();
  for (const [from, to, vertex] of openEdges(triangles, welded)) {
    if (next.has(from)) pinched.add(from);
    next.set(from, to);
    vertexOf.set(from, vertex);
  }
  const seen = new Set<number>();
  const loops: Loop[] = [];
  for (const start of next.keys()) {
    if (seen.has(start)) continue;
    const loop: number[] = [];
    let at: number | undefined = start;
    while (at !== undefined && !seen.has(at)) {
      seen.add(at);
      loop.push(at);
      at = next.get(at);
    }
    const whole = at === start && loop.length >= 3 && !loop.some((place) => pinched.has(place));
    if (whole) loops.push(loop.map((place) => vertexOf.get(place)!));
  }
  return loops.sort((a, b) => b.length - a.length);
}

/** Edges with a face on their left only: their two places, and the file vertex they start from. */
function openEdges(triangles: Uint32Array, welded: Int32Array): [number, number, number][] {
  const places = welded.reduce((most, place) => Math.max(most, place + 1), 0);
  const edges = new Map<number, [number, number, number] | null>();
  for (let i = 0; i < triangles.length; i++) {
    const vertex = triangles[i]!;
    const from = welded[vertex]!;
    const to = welded[triangles[i % 3 === 2 ? i - 2 : i + 1]!]!;
    const key = Math.min(from, to) * places + Math.max(from, to);
    edges.set(key, edges.has(key) ? null : [from, to, vertex]);
  }
  return [...edges.values()].filter((edge) => edge !== null);
}

/** Arc length from the loop's first vertex to each of its vertices, and last the whole loop's. */
export function arcLengths(loop: Loop, positions: Float64Array): Float64Array {
  const lengths = new Float64Array(loop.length + 1);
  for (let i = 0; i < loop.length; i++) {
    const [a, b] = [3 * loop[i]!, 3 * loop[(i + 1) % loop.length]!];
    const step = Math.hypot(
      positions[b]! - positions[a]!,
      positions[b + 1]! - positions[a + 1]!,
      positions[b + 2]! - positions[a + 2]!,
    );
    lengths[i + 1] = lengths[i]! + step;
  }
  return lengths;
}

/** The loop's vertex whose arc length is nearest, going round; `lengths` as from `arcLengths`. */
export function indexAt(lengths: Float64Array, length: number): number {
  const count = lengths.length - 1;
  const whole = lengths[count]!;
  const wanted = whole > 0 ? ((length % whole) + whole) % whole : 0;
  let best = 0;
  let least = Infinity;
  for (let i = 0; i < count; i++) {
    const off = Math.abs(lengths[i]! - wanted);
    const gap = Math.min(off, whole - off);
    if (gap < least) [best, least] = [i, gap];
  }
  return best;
}

/** How far each vertex lies from the nearest of some others, straight through space. */
export function distancesTo(positions: Float64Array, vertices: readonly number[]): Float64Array {
  const off = new Float64Array(positions.length / 3);
  for (let v = 0; v < off.length; v++) {
    const [x, y, z] = [positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!];
    let least = Infinity;
    for (const w of vertices) {
      const [a, b, c] = [positions[3 * w]! - x, positions[3 * w + 1]! - y, positions[3 * w + 2]! - z];
      least = Math.min(least, a * a + b * b + c * c);
    }
    off[v] = Math.sqrt(least);
  }
  return off;
}
