// Meshes made from formulas: as many vertices as a test needs, every one off any symmetry that could hide a mistake.

import type { Model } from '../../web/core/model';

type Point = readonly [number, number, number];

export function modelOf(
  name: string,
  points: readonly Point[],
  faces: readonly (readonly number[])[],
): Model {
  const offsets = [0];
  for (const face of faces) offsets.push(offsets.at(-1)! + face.length);
  return {
    name,
    positions: Float64Array.from(points.flat()),
    faceOffsets: Uint32Array.from(offsets),
    faceVertices: Uint32Array.from(faces.flat()),
  };
}

/** An open sheet of n × m quads: one boundary. */
export function sheet(n: number, m: number): Model {
  return grid('sheet', n + 1, m + 1, false, (i, j) => [
    i / n,
    (0.7 * j) / m,
    0.1 * Math.sin((5 * i) / n) + 0.07 * Math.cos((4 * j) / m + (2 * i) / n),
  ]);
}

/** A ring: genus 1, closed. */
export function torus(n: number, m: number): Model {
  return grid('torus', n, m, true, (i, j) => {
    const [a, b] = [(2 * Math.PI * i) / n, (2 * Math.PI * j) / m];
    const r = 1 + (0.35 + 0.05 * Math.sin(3 * a)) * Math.cos(b);
    return [r * Math.cos(a), r * Math.sin(a), 0.35 * Math.sin(b) + 0.04 * Math.cos(2 * a)];
  });
}

/** A closed ball without poles' fans: two caps of one vertex each. */
export function ball(n: number, m: number, centre: Point = [0, 0, 0]): Model {
  const points: Point[] = [];
  const at = (i: number, j: number) => 1 + (i - 1) * m + (j % m);
  const place = (u: number, w: number): Point => {
    const r = 1 + 0.15 * Math.sin(3 * u) * Math.cos(2 * w);
    return [
      centre[0] + r * Math.sin(u) * Math.cos(w),
      centre[1] + r * Math.cos(u),
      centre[2] - 0.8 * r * Math.sin(u) * Math.sin(w),
    ];
  };
  points.push(place(0, 0));
  for (let i = 1; i < n; i++)
    for (let j = 0; j < m; j++) points.push(place((Math.PI * i) / n, (2 * Math.PI * j) / m));
  points.push(place(Math.PI, 0));
  const faces: number[][] = [];
  for (let j = 0; j < m; j++) {
    faces.push([0, at(1, j), at(1, j + 1)], [points.length - 1, at(n - 1, j + 1), at(n - 1, j)]);
    for (let i = 1; i < n - 1; i++) faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
  }
  return modelOf('ball', points, faces);
}

/** Several models in one file, one component each. */
export function together(...models: readonly Model[]): Model {
  const points: Point[] = [];
  const faces: number[][] = [];
  for (const model of models) {
    const first = points.length;
    for (let v = 0; v < model.positions.length; v += 3)
      points.push([model.positions[v]!, model.positions[v + 1]!, model.positions[v + 2]!]);
    for (let f = 1; f < model.faceOffsets.length; f++)
      faces.push(
        [...model.faceVertices.slice(model.faceOffsets[f - 1], model.faceOffsets[f])].map((v) => v + first),
      );
  }
  return modelOf('together', points, faces);
}

/** The same model with vertex i numbered `order[i]`. */
export function renumbered(model: Model, order: readonly number[]): Model {
  const positions = new Float64Array(model.positions.length);
  for (const [from, to] of order.entries())
    positions.set(model.positions.subarray(3 * from, 3 * from + 3), 3 * to);
  return { ...model, positions, faceVertices: model.faceVertices.map((v) => order[v]!) };
}

/** A fixed shuffle of 0 … n − 1. */
export function shuffle(n: number): number[] {
  const order = Array.from({ length: n }, (_, i) => i);
  let state = 12345;
  for (let i = n - 1; i > 0; i--) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const j = state % (i + 1);
    [order[i], order[j]] = [order[j]!, order[i]!];
  }
  return order;
}

export function diagonal({ positions }: Model): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const [at, value] of positions.entries()) {
    low[at % 3] = Math.min(low[at % 3]!, value);
    high[at % 3] = Math.max(high[at % 3]!, value);
  }
  return Math.hypot(...high.map((value, axis) => value - low[axis]!));
}

/** Greatest distance between vertices of equal number. */
export function gap(a: Float64Array, b: Float64Array): number {
  if (a.length !== b.length) return Infinity;
  let worst = 0;
  for (let v = 0; v < a.length; v += 3) {
    const distance = Math.hypot(a[v]! - b[v]!, a[v + 1]! - b[v + 1]!, a[v + 2]! - b[v + 2]!);
    if (Number.isNaN(distance)) return distance;
    worst = Math.max(worst, distance);
  }
  return worst;
}

/** @param matrix  16 numbers, column-major */
export function transformed({ positions }: Model, matrix: readonly number[]): Float64Array {
  const out = new Float64Array(positions.length);
  for (let v = 0; v < positions.length; v += 3)
    for (let row = 0; row < 3; row++)
      out[v + row] =
        matrix[row]! * positions[v]! +
        matrix[4 + row]! * positions[v + 1]! +
        matrix[8 + row]! * positions[v + 2]! +
        matrix[12 + row]!;
  return out;
}

function grid(
  name: string,
  n: number,
  m: number,
  around: boolean,
  place: (i: number, j: number) => Point,
): Model {
  const points: Point[] = [];
  for (let i = 0; i < n; i++) for (let j = 0; j < m; j++) points.push(place(i, j));
  const at = (i: number, j: number) => (i % n) * m + (j % m);
  const faces: number[][] = [];
  for (let i = 0; i < n - (around ? 0 : 1); i++)
    for (let j = 0; j < m - (around ? 0 : 1); j++)
      faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
  return modelOf(name, points, faces);
}
