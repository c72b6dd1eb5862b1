import { orientationBetween } from '../core/orientation';
import type { Quaternion } from '../core/quaternion';
import type { Vec3 } from '../view/types';
import { centroid, IDENTITY, type Mat4, pointAt, subtract, transform } from './geometry';

/**
 * The rotation and translation that take `vertices` of `from` closest to those of `to` (least squares).
 * Points that leave the rotation open (fewer than three, or all alike) only move.
 * @returns exactly the identity where nothing has moved
 */
export function rigidFit(from: Float64Array, to: Float64Array, vertices: Uint32Array): Mat4 {
  const finite = vertices.filter((v) => pointAt(from, v).every(Number.isFinite));
  if (finite.every((v) => pointAt(from, v).every((x, k) => x === to[3 * v + k]))) return IDENTITY;
  const a = centroid(from, finite);
  const b = centroid(to, finite);
  const rotation = finite.length < 3 ? IDENTITY : rotationBetween(from, to, finite, a, b);
  const turned = transform(rotation, a);
  const [x, y, z] = subtract(b, turned);
  return [...rotation.slice(0, 12), x, y, z, 1];
}

function rotationBetween(
  from: Float64Array,
  to: Float64Array,
  vertices: Uint32Array,
  a: Vec3,
  b: Vec3,
): Mat4 {
  const s = new Float64Array(9); // s[3 j + k] = Σ p_j q_k
  for (const v of vertices) {
    const p = subtract(pointAt(from, v), a);
    const q = subtract(pointAt(to, v), b);
    for (let j = 0; j < 3; j++) for (let k = 0; k < 3; k++) s[3 * j + k]! += p[j]! * q[k]!;
  }
  return fromQuaternion(orientationBetween(s).rotation);
}

function fromQuaternion([x, y, z, w]: Quaternion): Mat4 {
  return [
    ...[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0],
    ...[2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0],
    ...[2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0],
    ...[0, 0, 0, 1],
  ];
}
