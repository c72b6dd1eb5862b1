// Small shapes for the view's tests.

export interface Shape {
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
}

export const identityWeld = (count: number): Int32Array => Int32Array.from({ length: count }, (_, i) => i);

/** Corners at ±1; vertex v has its signs in the bits of v. */
export function box(): Shape {
  const positions = Float64Array.from({ length: 24 }, (_, i) =>
    (Math.floor(i / 3) >> (i % 3)) & 1 ? 1 : -1,
  );
  const quads = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
  ];
  const triangles = Uint32Array.from(quads.flatMap(([a, b, c, d]) => [a!, b!, c!, a!, c!, d!]));
  return { positions, triangles };
}

/** A unit sphere: an octahedron's faces, each cut into n² triangles and blown up. */
export function sphere(n: number): Shape {
  const places: number[] = [];
  const triangles: number[] = [];
  const known = new Map<string, number>();
  const vertex = (p: readonly [number, number, number]): number => {
    const key = p.join();
    const old = known.get(key);
    if (old !== undefined) return old;
    const length = Math.hypot(...p);
    places.push(p[0] / length, p[1] / length, p[2] / length);
    known.set(key, known.size);
    return known.size - 1;
  };
  for (const sx of [-1, 1]) {
    for (const sy of [-1, 1]) {
      for (const sz of [-1, 1]) {
        const at = (i: number, j: number): number =>
          vertex([sx * i || 0, sy * j || 0, sz * (n - i - j) || 0]);
        const add = (a: number, b: number, c: number): void => {
          triangles.push(...(sx * sy * sz > 0 ? [a, b, c] : [a, c, b]));
        };
        for (let i = 0; i < n; i++) {
          for (let j = 0; j < n - i; j++) {
            add(at(i, j), at(i + 1, j), at(i, j + 1));
            if (i + j < n - 1) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
          }
        }
      }
    }
  }
  return { positions: Float64Array.from(places), triangles: Uint32Array.from(triangles) };
}

/** A square sheet of (n+1)² vertices at z, x and y from 0 to n. */
export function sheet(n: number, z = 0): Shape {
  const places: number[] = [];
  const triangles: number[] = [];
  for (let j = 0; j <= n; j++) for (let i = 0; i <= n; i++) places.push(i, j, z);
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const a = j * (n + 1) + i;
      triangles.push(a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
    }
  }
  return { positions: Float64Array.from(places), triangles: Uint32Array.from(triangles) };
}

/** Both shapes, unconnected. */
export function both(a: Shape, b: Shape): Shape {
  const shift = a.positions.length / 3;
  return {
    positions: Float64Array.from([...a.positions, ...b.positions]),
    triangles: Uint32Array.from([...a.triangles, ...Array.from(b.triangles, (v) => v + shift)]),
  };
}
