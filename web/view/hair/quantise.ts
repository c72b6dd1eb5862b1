import type { EvenStrands } from './resample';

/** Texels in a row of the texture that holds all points; a power of two, as the shader shifts by its bits. */
export const ROW_BITS = 12;
export const ROW = 1 << ROW_BITS;
const STEPS = 65535;

/** Points as the texture holds them: 4 whole numbers each, place in the box and the strand's group. */
export interface PackedStrands {
  readonly texels: Uint16Array;
  readonly rows: number;
  readonly low: readonly [number, number, number];
  readonly size: readonly [number, number, number];
}

/** The most strands that fit a texture with `rows` rows. */
export const fitting = (perStrand: number, rows: number): number => Math.floor((rows * ROW) / perStrand);

/**
 * Error at most half a step: 1/131070 of the box's side, 5 µm for a groom of 60 cm.
 *
 * @param groups  per strand; strands of a group share a tint
 */
export function pack(strands: EvenStrands, groups?: Uint32Array): PackedStrands {
  const { points, perStrand, count, low, high } = strands;
  const total = count * perStrand;
  const rows = Math.max(1, Math.ceil(total / ROW));
  const texels = new Uint16Array(4 * ROW * rows);
  const size = [0, 1, 2].map((k) => Math.max(high[k]! - low[k]!, 1e-6)) as [number, number, number];
  const [sx, sy, sz] = [STEPS / size[0], STEPS / size[1], STEPS / size[2]];
  for (let s = 0, p = 0, t = 0; s < count; s++) {
    const group = (groups?.[s] ?? 0) & 0xffff;
    for (let i = 0; i < perStrand; i++, p += 3, t += 4) {
      texels[t] = whole((points[p]! - low[0]) * sx);
      texels[t + 1] = whole((points[p + 1]! - low[1]) * sy);
      texels[t + 2] = whole((points[p + 2]! - low[2]) * sz);
      texels[t + 3] = group;
    }
  }
  return { texels, rows, low, size };
}

/** As the vertex shader reads it back. */
export function unpack({ texels, low, size }: PackedStrands, point: number): [number, number, number] {
  const at = (k: number): number => low[k]! + (size[k]! * texels[4 * point + k]!) / STEPS;
  return [at(0), at(1), at(2)];
}

function whole(x: number): number {
  return x > 0 ? Math.min(STEPS, Math.round(x)) : 0;
}
