// Rotations as unit quaternions (x, y, z, w), as glTF and recipes write them.

export type Quaternion = readonly [number, number, number, number];
type Triple = readonly [number, number, number];

/** First `b`, then `a`. */
export const product = ([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion): Quaternion => [
  aw * bx + ax * bw + ay * bz - az * by,
  aw * by - ax * bz + ay * bw + az * bx,
  aw * bz + ax * by - ay * bx + az * bw,
  aw * bw - ax * bx - ay * by - az * bz,
];

/** v + 2 u × (u × v + w v) with u = (x, y, z). */
export function rotated([x, y, z, w]: Quaternion, [vx, vy, vz]: Triple): Triple {
  const [a, b, c] = [y * vz - z * vy + w * vx, z * vx - x * vz + w * vy, x * vy - y * vx + w * vz];
  return [vx + 2 * (y * c - z * b), vy + 2 * (z * a - x * c), vz + 2 * (x * b - y * a)];
}

export function unitQuaternion([x, y, z, w]: Quaternion): Quaternion {
  const length = Math.hypot(x, y, z, w);
  return [x / length, y / length, z / length, w / length];
}

/**
 * Of a rotation matrix (Shepperd 1978: from the largest of its four).
 *
 * @param at  its entries, by row and column
 */
export function quaternionOf(at: (row: number, column: number) => number): Quaternion {
  const trace = at(0, 0) + at(1, 1) + at(2, 2);
  const largest = [at(0, 0), at(1, 1), at(2, 2), trace].reduce(
    (best, x, k, all) => (x > all[best]! ? k : best),
    0,
  );
  if (largest === 3)
    return unitQuaternion([at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1), 1 + trace]);
  const [i, j, k] = [largest, (largest + 1) % 3, (largest + 2) % 3];
  const q: [number, number, number, number] = [0, 0, 0, at(k, j) - at(j, k)];
  q[i] = 1 - trace + 2 * at(i, i);
  q[j] = at(j, i) + at(i, j);
  q[k] = at(k, i) + at(i, k);
  return unitQuaternion(q);
}
