// Small polygon models made in code: no files, no surprises.

export interface Shape {
  readonly positions: Float64Array;
  readonly faceOffsets: Uint32Array;
  readonly faceVertices: Uint32Array;
}

type Point = readonly [number, number, number];

/** Quads over points; equal points (on an integer lattice) become one vertex. */
function fromQuads(quads: readonly (readonly Point[])[], place: (point: Point) => Point): Shape {
  const index = new Map<string, number>();
  const positions: number[] = [];
  const faceVertices = quads.flat().map((point) => {
    const key = point.join();
    const known = index.get(key);
    if (known !== undefined) return known;
    index.set(key, index.size);
    positions.push(...place(point));
    return index.size - 1;
  });
  return {
    positions: Float64Array.from(positions),
    faceOffsets: Uint32Array.from({ length: quads.length + 1 }, (_, face) => 4 * face),
    faceVertices: Uint32Array.from(faceVertices),
  };
}

const range = (n: number) => Array.from({ length: n }, (_, i) => i);

/** An open sheet of nx × ny quads with a gentle wave. */
export function sheet(nx: number, ny: number): Shape {
  const quads = range(nx * ny).map((k): Point[] => {
    const [x, y] = [k % nx, Math.floor(k / nx)];
    return [
      [x, y, 0],
      [x + 1, y, 0],
      [x + 1, y + 1, 0],
      [x, y + 1, 0],
    ];
  });
  return fromQuads(quads, ([x, y]) => [x, y, 0.5 * Math.sin(x / 2) * Math.cos(y / 3)]);
}

/** A closed bar of length × width × width unit quads along x; its flat sides are the degenerate case. */
export function bar(length: number, width: number): Shape {
  const size: Point = [length, width, width];
  const quads: Point[][] = [];
  for (const axis of [0, 1, 2]) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3] as [number, number];
    for (const side of [0, size[axis] as number])
      for (const i of range(size[u] as number))
        for (const j of range(size[v] as number)) {
          const corner = (du: number, dv: number): Point => {
            const point: [number, number, number] = [0, 0, 0];
            point[axis] = side;
            point[u] = i + du;
            point[v] = j + dv;
            return point;
          };
          const outward = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
          quads.push(side === 0 ? outward.reverse() : outward);
        }
  }
  return fromQuads(quads, (point) => point);
}

export const allVertices = ({ positions }: Shape): Uint32Array =>
  Uint32Array.from(range(positions.length / 3));

export const verticesWhere = (
  { positions }: Shape,
  test: (x: number, y: number, z: number) => boolean,
): Uint32Array =>
  Uint32Array.from(
    range(positions.length / 3).filter((v) =>
      test(...(positions.subarray(3 * v, 3 * v + 3) as unknown as Point)),
    ),
  );

/** Column-major 4×4 of x ↦ M x + t, M given by rows. */
export const affine = (rows: readonly Point[], move: Point): number[] => [
  ...[0, 1, 2].flatMap((column) => [...rows.map((row) => row[column] as number), 0]),
  ...move,
  1,
];

/** The positions under a column-major 4×4. */
export function transformed(positions: Float64Array, m: readonly number[]): Float64Array {
  return positions.map((_, at) => {
    const [v, row] = [at - (at % 3), at % 3];
    return [0, 1, 2].reduce(
      (sum, column) => sum + (m[4 * column + row] as number) * (positions[v + column] as number),
      m[12 + row] as number,
    );
  });
}

export function diagonal(positions: Float64Array): number {
  const sides = [0, 1, 2].map((axis) => {
    const values = positions.filter((_, at) => at % 3 === axis);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.hypot(...sides);
}

/** Largest distance between corresponding coordinates, in diagonals of `b`. NaN if either has one. */
export const gap = (a: Float64Array, b: Float64Array): number =>
  a.reduce((worst, value, at) => Math.max(worst, Math.abs(value - (b[at] as number))), 0) / diagonal(b);
