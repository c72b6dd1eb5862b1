// The blend vertex by vertex, as the paper writes it: what the kernel and the graphics card are both held to.

import type { IsolineSurface } from '../../../web/view/deform/types';

type Formula = Pick<IsolineSurface, 'sets' | 'single' | 'basis' | 'controls' | 'fields' | 'still'>;

/** @returns 3 numbers a vertex: x + Σ_i φ_i Σ_j b_j(φ_i) d_ij (x, 1) */
export function blended(surface: Formula, offsets: Float64Array, rest: Float64Array): Float64Array {
  const { sets, single, controls, fields, still } = surface;
  return rest.map((x, at) => {
    const [vertex, axis] = [Math.floor(at / 3), at % 3];
    if (still?.[vertex]) return x;
    let sum = x;
    for (let set = 0; set < sets; set++) {
      const phi = fields[sets * vertex + set]!;
      const share = single ? 1 : phi;
      if (share === 0) continue;
      for (let j = 0; j < controls; j++) {
        const weight = share * basis(surface.basis, controls, j, phi);
        if (weight === 0) continue;
        const row = 12 * (controls * set + j) + 4 * axis;
        sum += weight * (offsets[row + 3]! + dot(offsets, row, rest, 3 * vertex));
      }
    }
    return sum;
  });
}

const dot = (a: Float64Array, i: number, b: Float64Array, j: number): number =>
  a[i]! * b[j]! + a[i + 1]! * b[j + 1]! + a[i + 2]! * b[j + 2]!;

/** Function j of `controls`, by the recursion of Cox and de Boor over clamped even knots. */
function basis(kind: IsolineSurface['basis'], controls: number, j: number, phi: number): number {
  const degree = kind === 'quadratic' ? 2 : 1;
  const spans = controls - degree;
  const knot = (k: number): number => Math.min(spans, Math.max(0, k - degree)) / spans;
  const at = Math.min(phi, 1 - 1e-15);
  const value = (k: number, p: number): number => {
    if (p === 0) return knot(k) <= at && at < knot(k + 1) ? 1 : 0;
    const rise = knot(k + p) - knot(k);
    const fall = knot(k + p + 1) - knot(k + 1);
    return (
      (rise > 0 ? ((at - knot(k)) / rise) * value(k, p - 1) : 0) +
      (fall > 0 ? ((knot(k + p + 1) - at) / fall) * value(k + 1, p - 1) : 0)
    );
  };
  return value(j, degree);
}
