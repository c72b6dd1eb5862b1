import type { Vec3 } from '../view/types';
import { centroid, IDENTITY, type Mat4, pointAt, subtract, transform } from './geometry';

/**
 * The rotation and translation that take `vertices` of `from` closest to those of `to` (least squares).
 * Source: Horn, "Closed-form solution of absolute orientation using unit quaternions", JOSA A 4(4), 1987:
 * the rotation is the quaternion that belongs to the largest eigenvalue of a 4×4 matrix, found here by
 * cyclic Jacobi rotations. Points that leave the rotation open (fewer than three, or all alike) only move.
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
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = s as unknown as Nine;
  const quaternion = principal([
    [xx + yy + zz, yz - zy, zx - xz, xy - yx],
    [yz - zy, xx - yy - zz, xy + yx, zx + xz],
    [zx - xz, xy + yx, yy - xx - zz, yz + zy],
    [xy - yx, zx + xz, yz + zy, zz - xx - yy],
  ]);
  return fromQuaternion(quaternion);
}

type Nine = [number, number, number, number, number, number, number, number, number];
type Quaternion = [number, number, number, number];

/** Unit eigenvector of the largest eigenvalue of a symmetric 4×4 matrix; (1, 0, 0, 0) when all are equal. */
function principal(m: number[][]): Quaternion {
  const vectors = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((j) => (i === j ? 1 : 0)));
  for (let sweep = 0; sweep < 30; sweep++) {
    let off = 0;
    for (let p = 0; p < 3; p++)
      for (let q = p + 1; q < 4; q++) {
        off += Math.abs(m[p]![q]!);
        rotate(m, vectors, p, q);
      }
    if (off === 0) break;
  }
  let best = 0;
  for (let i = 1; i < 4; i++) if (m[i]![i]! > m[best]![best]!) best = i;
  return [0, 1, 2, 3].map((i) => vectors[i]![best]!) as Quaternion;
}

/** One Jacobi rotation: brings m[p][q] to zero. */
function rotate(m: number[][], vectors: number[][], p: number, q: number): void {
  const apq = m[p]![q]!;
  if (apq === 0) return;
  const theta = (m[q]![q]! - m[p]![p]!) / (2 * apq);
  const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(1, theta));
  const c = 1 / Math.hypot(1, t);
  const s = t * c;
  for (let k = 0; k < 4; k++) {
    const [kp, kq] = [m[k]![p]!, m[k]![q]!];
    m[k]![p] = c * kp - s * kq;
    m[k]![q] = s * kp + c * kq;
  }
  for (let k = 0; k < 4; k++) {
    const [pk, qk] = [m[p]![k]!, m[q]![k]!];
    m[p]![k] = c * pk - s * qk;
    m[q]![k] = s * pk + c * qk;
    const [vp, vq] = [vectors[k]![p]!, vectors[k]![q]!];
    vectors[k]![p] = c * vp - s * vq;
    vectors[k]![q] = s * vp + c * vq;
  }
  m[p]![q] = 0;
  m[q]![p] = 0;
}

function fromQuaternion([w, x, y, z]: Quaternion): Mat4 {
  return [
    ...[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0],
    ...[2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0],
    ...[2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0],
    ...[0, 0, 0, 1],
  ];
}
