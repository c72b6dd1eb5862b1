import { LissomError } from '../../core/errors';
import type { Groom, StrandLook } from '../../core/strands';
import { farOrigin } from '../gltf-build';
import { bounds, isLine } from './curves';

/** Strands as a file gave them, in its own unit. */
export interface ReadStrands {
  readonly offsets: Uint32Array;
  readonly points: ArrayLike<number>;
  /** Diameter per point, and the one for all where there is none. */
  readonly widths?: Float32Array | undefined;
  readonly width?: number;
  /** sRGB in [0, 1] per point, and the one for all where there is none. */
  readonly colors?: Float32Array | undefined;
  readonly color?: readonly number[];
}

/** A hair is so thick beside a head of hair, where the file says nothing: 0.07 mm to 25 cm. */
const USUAL_THICKNESS = 3e-4;
const USUAL_COLOR = [0.35, 0.22, 0.13];
/** Strands are shown in single precision, which ends at 3.4e38; differences of coordinates must fit as well. */
const FARTHEST = 1e38;

/**
 * The groom of a file. Strands of fewer than two points or with coordinates that single precision lacks are left out; of
 * thickness and colour remain what a look can hold: means over all roots and tips.
 *
 * @throws LissomError `no-strands`
 */
export function groomOf(name: string, read: ReadStrands): Groom {
  const kept: number[] = [];
  for (let s = 0; s + 1 < read.offsets.length; s++) if (isLine(read, s) && isNear(read, s)) kept.push(s);
  if (kept.length === 0) {
    const message = `${name} holds no strand of two or more points. Open a .hair file, or an OBJ with lines (“l”).`;
    throw new LissomError('no-strands', message);
  }
  const offsets = new Uint32Array(kept.length + 1);
  kept.forEach((s, i) => {
    offsets[i + 1] = offsets[i]! + read.offsets[s + 1]! - read.offsets[s]!;
  });
  const full = new Float64Array(3 * offsets.at(-1)!);
  for (let i = 0; i < kept.length; i++) {
    const from = 3 * read.offsets[kept[i]!]!;
    const to = 3 * offsets[i]!;
    const length = 3 * offsets[i + 1]! - to;
    for (let k = 0; k < length; k++) full[to + k] = read.points[from + k]!;
  }
  const origin = farOrigin(full) as [number, number, number];
  const points = new Float32Array(full.length);
  for (let p = 0; p < full.length; p += 3)
    for (let k = 0; k < 3; k++) points[p + k] = full[p + k]! - origin[k]!;
  return { name, strands: { offsets, points, origin, look: lookOf(read, kept, points) } };
}

function isNear({ offsets, points }: ReadStrands, s: number): boolean {
  for (let i = 3 * offsets[s]!; i < 3 * offsets[s + 1]!; i++)
    if (Math.abs(points[i]!) > FARTHEST) return false;
  return true;
}

function lookOf(read: ReadStrands, kept: readonly number[], points: Float32Array): StrandLook {
  const { offsets, widths, colors } = read;
  const root = widths ? mean(kept, (s) => widths[offsets[s]!]!) : (read.width ?? 0);
  const tip = widths ? mean(kept, (s) => widths[offsets[s + 1]! - 1]!) : root;
  const known = root > 0 && root < Infinity;
  const { min, max } = bounds(points);
  const size = Math.hypot(...min.map((low, k) => max[k]! - low));
  const rgb = colors
    ? [0, 1, 2].map((k) => mean(kept, (s) => colors[3 * offsets[s]! + k]!))
    : (read.color ?? USUAL_COLOR);
  return {
    thickness: known ? root : USUAL_THICKNESS * size,
    taper: known && tip >= 0 && tip < Infinity ? tip / root : 1,
    color: hexOf(rgb),
    colorVariation: 0,
  };
}

const mean = (strands: readonly number[], value: (s: number) => number): number =>
  strands.reduce((sum, s) => sum + value(s), 0) / strands.length;

const hexOf = (rgb: readonly number[]): string =>
  `#${rgb
    .map((level) =>
      Math.round(255 * Math.min(1, Math.max(0, level || 0)))
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;
