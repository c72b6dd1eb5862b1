import type { Quaternion } from './quaternion';

/** Sums of products of points about their middle with those that they go to: s[3 j + k] = Σ w p_j q_k. */
export type Moments = Float64Array;

export interface Orientation {
  readonly rotation: Quaternion;
  /** Σ w q · R p, the largest that a rotation can make it. */
  readonly largest: number;
  /** The next of the four: where both are the same the rotation is open. */
  readonly next: number;
}

/**
 * The rotation that takes points closest to others (least squares).
 * Source: Horn, "Closed-form solution of absolute orientation using unit quaternions", JOSA A 4(4), 1987:
 * it is the quaternion that belongs to the largest eigenvalue of a 4×4 matrix, found here by cyclic Jacobi rotations.
 *
 * @returns no turn where all eigenvalues are equal
 */
export function orientationBetween(moments: Moments): Orientation {
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = moments as unknown as Nine;
  const m = [
    [xx + yy + zz, yz - zy, zx - xz, xy - yx],
    [yz - zy, xx - yy - zz, xy + yx, zx + xz],
    [zx - xz, xy + yx, yy - xx - zz, yz + zy],
    [xy - yx, zx + xz, yz + zy, zz - xx - yy],
  ];
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
  const [w, x, y, z] = vectors.map((row) => row[best]!) as [number, number, number, number];
  const others = [0, 1, 2, 3].filter((i) => i !== best).map((i) => m[i]![i]!);
  return { rotation: [x, y, z, w], largest: m[best]![best]!, next: Math.max(...others) };
}

type Nine = [number, number, number, number, number, number, number, number, number];

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
