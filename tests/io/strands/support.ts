import type { Model } from '../../../web/core/model';
import type { Groom, StrandLook } from '../../../web/core/strands';
import { makeModel } from '../support';

export const LOOK: StrandLook = { thickness: 0.07, taper: 0.4, color: '#6a4020', colorVariation: 0.3 };
/** Head units are millimetres in these tests. */
export const MILLIMETRES = { centimetresPerUnit: 0.1 } as const;

/** A box for a head, 160 × 240 × 200 mm, with a texture coordinate per corner; its faces look outwards. */
export const HEAD: Model = {
  ...makeModel(
    [
      -80, -120, -100, 80, -120, -100, 80, 120, -100, -80, 120, -100, -80, -120, 100, 80, -120, 100, 80, 120,
      100, -80, 120, 100,
    ],
    [
      [0, 3, 2, 1],
      [4, 5, 6, 7],
      [0, 1, 5, 4],
      [3, 7, 6, 2],
      [0, 4, 7, 3],
      [1, 2, 6, 5],
    ],
  ),
  name: 'box.obj',
  uvs: Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1),
  uvIndices: Uint32Array.from({ length: 24 }, (_, i) => i % 4),
};

/** Strands that wave down from a cap over the head: numbers from a sine, so that none is round. */
export function makeGroom(
  count: number,
  points: (strand: number) => number,
  extra: Partial<Groom> = {},
): Groom {
  const offsets = new Uint32Array(count + 1);
  for (let s = 0; s < count; s++) offsets[s + 1] = offsets[s]! + points(s);
  const all = new Float32Array(3 * offsets[count]!);
  const rootUvs = new Float32Array(2 * count);
  for (let s = 0; s < count; s++) {
    const u = (s * 0.618034) % 1;
    const v = (s + 0.5) / count;
    rootUvs.set([u, v], 2 * s);
    const angle = 2 * Math.PI * u;
    const out = 90 * Math.sqrt(v);
    for (let p = offsets[s]!; p < offsets[s + 1]!; p++) {
      const k = p - offsets[s]!;
      const radius = out + 12 * Math.sin(0.7 * k + s) * (k > 0 ? 1 : 0) + 4 * k;
      all.set([radius * Math.cos(angle), 130 - 30 * v - 6.3 * k, radius * Math.sin(angle)], 3 * p);
    }
  }
  const groups = Uint32Array.from({ length: count }, (_, s) => s % 3);
  const strands = { offsets, points: all, origin: [0, 0, 0] as const, rootUvs, groups, look: LOOK };
  return { name: 'wavy', strands, head: HEAD, ...extra };
}

/** Points of strand s in centimetres, as numbers of single precision. */
export const inCentimetres = ({ strands }: Groom): Float32Array =>
  Float32Array.from(strands.points, (c, i) => 0.1 * (c + strands.origin[i % 3]!));

export const greatestGap = (a: ArrayLike<number>, b: ArrayLike<number>): number => {
  let gap = a.length === b.length ? 0 : Infinity;
  for (let i = 0; i < a.length; i++) gap = Math.max(gap, Math.abs(a[i]! - b[i]!));
  return gap;
};
