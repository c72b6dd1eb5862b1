import { LissomError } from '../../core/errors';
import { type Groom, strandCount } from '../../core/strands';
import { chooseGuides, usualGuideCount } from './guides';
import { brightness, diameter, linearColor } from './look';
import type { StrandWriteOptions } from './options';
import { toFileSpace } from './space';

/** Strands as every writer takes them: centimetres, Y up, each with two points at least, all finite. */
export interface Curves {
  /** Strands + 1 offsets into `points`, counted in points. */
  readonly offsets: Uint32Array;
  /** 3 per point, root first. */
  readonly points: Float32Array;
  /** Diameter per point. */
  readonly widths: Float32Array;
  /** Linear red, green, blue per strand. */
  readonly colors: Float32Array;
  /** Number of each strand in the groom. */
  readonly ids: Uint32Array;
  readonly rootUvs?: Float32Array;
  readonly groups?: Uint32Array;
}

export const curveCount = (curves: Curves): number => curves.ids.length;
export const pointCount = (curves: Curves): number => curves.widths.length;

/**
 * The strands that go out, thinned as the options say.
 *
 * @param most  points a strand may have in the format; longer ones keep so many, evenly spread
 * @throws LissomError `nothing-to-export` without a strand of two finite points
 */
export function curvesToWrite(groom: Groom, options: StrandWriteOptions, most = Infinity): Curves {
  const curves = curvesOf(groom, chosen(groom, options), options, most);
  if (curveCount(curves) > 0) return curves;
  const message = `${groom.name} has no strand of two or more points to export. Grow the hair first.`;
  throw new LissomError('nothing-to-export', message);
}

function chosen(
  { strands, guides }: Groom,
  { guidesOnly, strandShare = 1 }: StrandWriteOptions,
): Uint32Array {
  const count = strandCount(strands);
  if (guidesOnly) return guides ?? chooseGuides(strands, usualGuideCount(count));
  return Uint32Array.from({ length: Math.ceil(count * strandShare) }, (_, i) => i);
}

/** The strands named by `indices`, without those that are no line. */
export function curvesOf(
  { strands, head }: Groom,
  indices: Uint32Array,
  { centimetresPerUnit, pointStride = 1 }: StrandWriteOptions,
  most = Infinity,
): Curves {
  const { origin, look, rootUvs, groups } = strands;
  const ids = indices.filter((s) => isLine(strands, s));
  const offsets = new Uint32Array(ids.length + 1);
  ids.forEach((s, i) => {
    const points = strands.offsets[s + 1]! - strands.offsets[s]!;
    offsets[i + 1] = offsets[i]! + Math.min(most, Math.ceil((points - 1) / pointStride) + 1);
  });
  const total = offsets.at(-1)!;
  const points = new Float32Array(3 * total);
  const widths = new Float32Array(total);
  const colors = new Float32Array(3 * ids.length);
  const place = toFileSpace(centimetresPerUnit, head?.upAxis);
  const color = linearColor(look.color);
  for (let i = 0; i < ids.length; i++) {
    const s = ids[i]!;
    const first = strands.offsets[s]!;
    const last = strands.offsets[s + 1]! - 1;
    const start = offsets[i]!;
    const kept = offsets[i + 1]! - start;
    const even = kept === most;
    for (let k = 0; k < kept; k++) {
      const step = even ? Math.round((k * (last - first)) / (kept - 1)) : k * pointStride;
      const p = Math.min(first + step, last);
      place(strands.points, p, origin, points, start + k);
      widths[start + k] = centimetresPerUnit * diameter(look, (p - first) / (last - first));
    }
    const bright = brightness(s, look.colorVariation);
    for (let k = 0; k < 3; k++) colors[3 * i + k] = Math.min(1, Math.max(0, color[k]! * bright));
  }
  return {
    offsets,
    points,
    widths,
    colors,
    ids,
    ...(rootUvs && {
      rootUvs: Float32Array.from({ length: 2 * ids.length }, (_, k) => rootUvs[2 * ids[k >> 1]! + (k & 1)]!),
    }),
    ...(groups && { groups: ids.map((s) => groups[s]!) }),
  };
}

/** Whether strand s has two points at least, all finite. */
export function isLine(
  { offsets, points }: { readonly offsets: Uint32Array; readonly points: ArrayLike<number> },
  s: number,
): boolean {
  const [start, end] = [offsets[s], offsets[s + 1]];
  if (start === undefined || end === undefined || end - start < 2) return false;
  for (let i = 3 * start; i < 3 * end; i++) if (!Number.isFinite(points[i]!)) return false;
  return true;
}

/** Least and greatest coordinates, `margin` beyond the points. */
export function bounds(points: ArrayLike<number>, margin = 0): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < 3; k++) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = k; i < points.length; i += 3) {
      const value = points[i]!;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    min[k] = low;
    max[k] = high;
  }
  return { min: min.map((c) => c - margin), max: max.map((c) => c + margin) };
}

export function greatest(values: ArrayLike<number>): number {
  let most = 0;
  for (let i = 0; i < values.length; i++) most = Math.max(most, Math.abs(values[i]!));
  return most;
}
