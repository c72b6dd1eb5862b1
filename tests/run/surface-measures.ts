// What tests measure of a surface by plain geometry, without the kernel.

import type { Model } from '../../web/core/model';

type Corners = readonly [number, number, number];

/** Vertices of each triangle; polygons as fans. */
export function cornersOf({ faceOffsets, faceVertices }: Model): Corners[] {
  const triangles: Corners[] = [];
  for (let f = 0; f + 1 < faceOffsets.length; f++)
    for (let k = faceOffsets[f]! + 1; k + 1 < faceOffsets[f + 1]!; k++)
      triangles.push([faceVertices[faceOffsets[f]!]!, faceVertices[k]!, faceVertices[k + 1]!]);
  return triangles;
}

/** Edges run along more than once in one direction, edges run along in one direction only, and pieces. */
export function topologyOf(model: Model): { twice: number; open: number; pieces: number; euler: number } {
  const triangles = cornersOf(model);
  const runs = new Map<string, number>();
  const root = new Map<number, number>();
  const find = (v: number): number => {
    let top = v;
    while ((root.get(top) ?? top) !== top) top = root.get(top)!;
    root.set(v, top);
    return top;
  };
  for (const triangle of triangles)
    for (const [c, v] of triangle.entries()) {
      const edge = `${v} ${triangle[(c + 1) % 3]}`;
      runs.set(edge, (runs.get(edge) ?? 0) + 1);
      root.set(find(v), find(triangle[(c + 1) % 3]!));
    }
  let [twice, open] = [0, 0];
  for (const [edge, times] of runs) {
    if (times > 1) twice++;
    if (!runs.has(edge.split(' ').reverse().join(' '))) open++;
  }
  const vertices = new Set(triangles.flat());
  const edges = (runs.size + open) / 2;
  return {
    twice,
    open,
    pieces: new Set([...vertices].map(find)).size,
    euler: vertices.size - edges + triangles.length,
  };
}

/** Vertices within so many edges of some. */
export function within(model: Model, start: Iterable<number>, rings: number): Set<number> {
  const found = new Set(start);
  const triangles = cornersOf(model);
  for (let ring = 0; ring < rings; ring++) {
    const next = triangles.filter((triangle) => triangle.some((v) => found.has(v)));
    for (const v of next.flat()) found.add(v);
  }
  return found;
}

/**
 * How much a map of triangles stretches one direction more than the other: the ratio of its singular values, 1 where it
 * is conformal.
 */
export function quasiConformal(
  from: readonly (readonly number[])[],
  to: readonly (readonly number[])[],
): number {
  const gram = (points: readonly (readonly number[])[]) => {
    const [u, v] = [1, 2].map((c) => points[c]!.map((x, k) => x - points[0]![k]!));
    const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, x, k) => sum + x * b[k]!, 0);
    return [dot(u!, u!), dot(u!, v!), dot(v!, v!)] as const;
  };
  const [a, b, c] = gram(from);
  const [p, q, r] = gram(to);
  // Eigenvalues of gram(to) relative to gram(from).
  const det = a * c - b * b;
  const half = (a * r - 2 * b * q + c * p) / (2 * det);
  const root = Math.sqrt(Math.max(0, half * half - (p * r - q * q) / det));
  return Math.sqrt((half + root) / Math.max(half - root, 1e-12 * half));
}
