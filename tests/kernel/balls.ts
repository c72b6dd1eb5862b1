import type { Shape } from './shapes';

type Point = readonly [number, number, number];

export interface Ball extends Shape {
  /** The vertices nearest to the ends of the six half axes: +x, +y, +z, −x, −y, −z. */
  readonly ends: readonly number[];
}

/** A ball cut into `rows` by `around`, its points placed anew: what stays a model without symmetry. */
export function ball(rows: number, around: number, place: (x: number, y: number, z: number) => Point): Ball {
  const points: Point[] = [[0, 1, 0]];
  for (let row = 1; row < rows; row++)
    for (let at = 0; at < around; at++) {
      const [u, t] = [(Math.PI * row) / rows, (2 * Math.PI * at) / around];
      points.push([Math.sin(u) * Math.cos(t), Math.cos(u), Math.sin(u) * Math.sin(t)]);
    }
  points.push([0, -1, 0]);
  const last = points.length - 1;
  const faces: number[][] = [];
  for (let at = 0; at < around; at++) {
    const next = (at + 1) % around;
    faces.push([0, 1 + next, 1 + at]);
    faces.push([last, last - around + at, last - around + next]);
    for (let row = 0; row < rows - 2; row++) {
      const [here, below] = [1 + row * around, 1 + (row + 1) * around];
      faces.push([here + at, here + next, below + at], [below + at, here + next, below + next]);
    }
  }
  const nearest = (axis: number, sign: number) =>
    points.reduce((best, point, at) => (sign * point[axis]! > sign * points[best]![axis]! ? at : best), 0);
  return {
    positions: Float64Array.from(points.flatMap((point) => place(...point))),
    faceOffsets: Uint32Array.from({ length: faces.length + 1 }, (_, face) => 3 * face),
    faceVertices: Uint32Array.from(faces.flat()),
    ends: [0, 1, 2, 3, 4, 5].map((end) => nearest(end % 3, end < 3 ? 1 : -1)),
  };
}

/** Two bodies that are alike enough to be matched, cut differently. */
export const pear = (): Ball => ball(16, 24, (x, y, z) => [x, 1.3 * y, z]);
export const plum = (): Ball => ball(20, 28, (x, y, z) => [1.4 * x, y, (1 + 0.2 * y) * z]);

/** A third. */
export const fig = (): Ball => ball(18, 22, (x, y, z) => [x * (1 - 0.3 * y), 1.1 * y, 0.8 * z]);

/** An open belt around such a body's middle, as wide as asked there. */
export function belt(radius: number, height = 0.4, rows = 8, around = 30): Shape {
  const positions: number[] = [];
  const faces: number[] = [];
  for (let row = 0; row <= rows; row++)
    for (let at = 0; at < around; at++) {
      const t = (2 * Math.PI * at) / around;
      positions.push(radius * Math.cos(t), height * ((2 * row) / rows - 1), radius * Math.sin(t));
      const [here, next] = [row * around + at, row * around + ((at + 1) % around)];
      if (row < rows) faces.push(here, here + around, next, next, here + around, next + around);
    }
  return {
    positions: Float64Array.from(positions),
    faceOffsets: Uint32Array.from({ length: faces.length / 3 + 1 }, (_, face) => 3 * face),
    faceVertices: Uint32Array.from(faces),
  };
}

/** The points of some vertices, 3 numbers each. */
export const pointsOf = ({ positions }: Shape, vertices: readonly number[]): Float64Array =>
  Float64Array.from(vertices.flatMap((vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]));
