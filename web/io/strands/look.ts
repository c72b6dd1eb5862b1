import type { StrandLook } from '../../core/strands';
import { fromSrgb } from '../srgb';

/** Diameter at the share t of the way from root (0) to tip (1). */
export const diameter = ({ thickness, taper }: StrandLook, t: number): number =>
  thickness * (1 + (taper - 1) * t);

/** Linear red, green and blue of `#rrggbb`, each in [0, 1]; black where it is no such colour. */
export function linearColor(hex: string): [number, number, number] {
  const levels = /^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})$/i.exec(hex)?.slice(1) ?? ['0', '0', '0'];
  return levels.map((level) => fromSrgb(Number.parseInt(level, 16))) as [number, number, number];
}

/**
 * How bright strand `id` is beside the look's colour, in [1 − v, 1 + v] for a variation v: the same strand has the
 * same tint in every file, whatever part of the hair is written.
 */
export const brightness = (id: number, variation: number): number => 1 + variation * (2 * noise(id) - 1);

/** An even number in [0, 1) for each id: an integer hash, equal on every machine. */
function noise(id: number): number {
  let held = Math.imul(id + 1, 0x9e3779b1);
  held = Math.imul(held ^ (held >>> 16), 0x7feb352d);
  held = Math.imul(held ^ (held >>> 15), 0x846ca68b);
  return ((held ^ (held >>> 16)) >>> 0) / 2 ** 32;
}
