import { type Affine, IDENTITY } from '../core/affine';

/** Translation · rotation (unit quaternion x y z w) · scale. */
export function compose(t: readonly number[], q: readonly number[], s: readonly number[]): Affine {
  const [x, y, z, w] = q as [number, number, number, number];
  const rotation = [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ];
  const columns = rotation.flatMap((column, k) => [...column.map((c) => c * s[k]!), 0]);
  return [...columns, ...t, 1];
}

export function determinant(m: Affine): number {
  const [a, b, c, , d, e, f, , g, h, i] = m as number[] as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  return a * (e * i - f * h) + d * (h * c - b * i) + g * (b * f - e * c);
}

/** @returns undefined where the matrix flattens space or is not finite */
export function invert(m: Affine): Affine | undefined {
  const det = determinant(m);
  if (det === 0 || !Number.isFinite(1 / det)) return undefined;
  const at = (row: number, column: number) => m[4 * (column % 3) + (row % 3)]!;
  const out = [...IDENTITY];
  for (let row = 0; row < 3; row++)
    for (let column = 0; column < 3; column++) {
      // Cofactor of (column, row); going round modulo 3 gives it the right sign.
      const [i, j] = [column, row];
      const minor = at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1);
      out[4 * column + row] = minor / det;
    }
  for (let row = 0; row < 3; row++) {
    let sum = 0;
    for (let k = 0; k < 3; k++) sum += out[4 * k + row]! * m[12 + k]!;
    out[12 + row] = -sum;
  }
  return out;
}

/** The points m · p of `points`, 3 numbers each. */
export function transformPoints(m: Affine, points: Float64Array): Float64Array {
  const out = new Float64Array(points.length);
  const [a, b, c, , d, e, f, , g, h, i, , x, y, z] = m as number[] as number[] & { length: 16 };
  for (let k = 0; k < points.length; k += 3) {
    const [p, q, r] = [points[k]!, points[k + 1]!, points[k + 2]!];
    out[k] = a! * p + d! * q + g! * r + x!;
    out[k + 1] = b! * p + e! * q + h! * r + y!;
    out[k + 2] = c! * p + f! * q + i! * r + z!;
  }
  return out;
}
