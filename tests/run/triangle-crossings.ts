// Which triangles of a surface pass through one another: exact but for rounding, with a grid of cells so that only
// near ones are looked at.

import type { Model } from '../../web/core/model';
import type { Vec } from './strand-measures';
import { cornersOf } from './surface-measures';

const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec, b: Vec) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec, b: Vec): Vec => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

type Triangle = readonly [Vec, Vec, Vec];

/** Whether the edge p–q passes through the inside of the triangle. Edges that only touch it do not. */
function pierces(p: Vec, q: Vec, [a, b, c]: Triangle): boolean {
  const n = cross(minus(b, a), minus(c, a));
  const [from, to] = [dot(n, minus(p, a)), dot(n, minus(q, a))];
  const small = 1e-9 * Math.sqrt(dot(n, n)) * Math.sqrt(dot(minus(q, p), minus(q, p)));
  if (Math.min(Math.abs(from), Math.abs(to)) <= small || from > 0 === to > 0) return false;
  const d = minus(q, p);
  // The line leaves all three sides on the same hand.
  const sides = [
    [a, b],
    [b, c],
    [c, a],
  ].map(([s, e]) => dot(d, cross(minus(s!, p), minus(e!, p))));
  return sides.every((x) => x > 0) || sides.every((x) => x < 0);
}

const crosses = (s: Triangle, t: Triangle): boolean =>
  [0, 1, 2].some((k) => pierces(s[k]!, s[(k + 1) % 3]!, t) || pierces(t[k]!, t[(k + 1) % 3]!, s));

/**
 * Pairs of triangles that pass through one another; those that share an edge are not looked at.
 *
 * @param near  vertices; only pairs with a triangle at one of them are looked at
 */
export function crossings(model: Model, near: ReadonlySet<number>): readonly (readonly [number, number])[] {
  const { positions } = model;
  const corners = cornersOf(model);
  const point = (v: number): Vec => [positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!];
  const places = corners.map((t) => t.map(point) as unknown as Triangle);
  let cell = 0;
  for (const [a, b] of places) cell += (2 * Math.sqrt(dot(minus(b, a), minus(b, a)))) / places.length;
  const grid = new Map<string, number[]>();
  const cellsOf = (triangle: Triangle): string[] => {
    const range = [0, 1, 2].map((k) => {
      const along = triangle.map((p) => Math.floor(p[k]! / cell));
      return [Math.min(...along), Math.max(...along)] as const;
    });
    const cells: string[] = [];
    for (let i = range[0]![0]; i <= range[0]![1]; i++)
      for (let j = range[1]![0]; j <= range[1]![1]; j++)
        for (let k = range[2]![0]; k <= range[2]![1]; k++) cells.push(`${i} ${j} ${k}`);
    return cells;
  };
  for (const [t, triangle] of places.entries())
    for (const key of cellsOf(triangle)) {
      const held = grid.get(key);
      if (held) held.push(t);
      else grid.set(key, [t]);
    }
  const found: (readonly [number, number])[] = [];
  for (const [t, triangle] of places.entries()) {
    if (!corners[t]!.some((v) => near.has(v))) continue;
    const others = new Set(cellsOf(triangle).flatMap((key) => grid.get(key) ?? []));
    for (const u of others)
      if (corners[u]!.filter((v) => corners[t]!.includes(v)).length < 2 && crosses(triangle, places[u]!))
        found.push([t, u]);
  }
  return found;
}
