// How densely hair is rooted about each vertex of its head. Hair this short of its root is thinner than the eye
// can tell apart: the skin itself looks darker.

import type { EvenStrands } from './resample';

/** Cells along the widest side of the scalp: about the width of a finger. */
const CELLS = 40;
/** So many roots tell as much as all. */
const ENOUGH = 20_000;

/**
 * @param places  of vertices, 3 numbers each, the strands' units
 * @returns per vertex 0..255: none; as dense about it as hair grows elsewhere on the head
 */
export function rootDensity(
  { points, perStrand, count }: EvenStrands,
  places: Float32Array,
): Uint8Array<ArrayBuffer> {
  const used = Math.min(count, ENOUGH);
  const out = new Uint8Array(places.length / 3);
  if (used === 0) return out;
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let s = 0; s < used; s++) {
    for (let k = 0; k < 3; k++) {
      const x = points[3 * s * perStrand + k]!;
      low[k] = Math.min(low[k]!, x);
      high[k] = Math.max(high[k]!, x);
    }
  }
  const cell = Math.max(1e-6, ...high.map((x, k) => x - low[k]!)) / CELLS;
  const n = CELLS + 3; // a rim of empty ones
  const cells = new Uint32Array(n * n * n);
  const at = (from: Float32Array, i: number): number => {
    let number = 0;
    for (let k = 2; k >= 0; k--) {
      const x = Math.floor((from[i + k]! - low[k]!) / cell) + 1;
      if (!(x >= 1 && x < n - 1)) return -1;
      number = number * n + x;
    }
    return number;
  };
  for (let s = 0; s < used; s++) {
    const c = at(points, 3 * s * perStrand);
    if (c >= 0) cells[c]!++;
  }
  const about = (c: number): number => {
    let sum = 0;
    for (let z = -1; z <= 1; z++)
      for (let y = -1; y <= 1; y++) for (let x = -1; x <= 1; x++) sum += cells[c + x + n * (y + n * z)]!;
    return sum;
  };
  let usual = 0;
  for (let s = 0; s < used; s++) {
    const c = at(points, 3 * s * perStrand);
    if (c >= 0) usual += about(c) / used;
  }
  for (let v = 0; v < out.length; v++) {
    const c = at(places, 3 * v);
    if (c >= 0) out[v] = Math.round(255 * Math.min(1, about(c) / Math.max(usual, 1e-9)));
  }
  return out;
}
