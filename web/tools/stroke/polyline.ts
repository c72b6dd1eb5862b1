// Polylines as strokes leave them. On the screen the third coordinate is 0.

import { roundTo } from '../../core/decimal';
import type { Vec3 } from '../../view/types';
import { dot, gap, mix, subtract } from '../geometry';

export type Line = readonly Vec3[];

export interface OnLine {
  /** The point lies between point `segment` and the next, `t` of the way. */
  readonly segment: number;
  readonly t: number;
  readonly point: Vec3;
  readonly distance: number;
}

export const lengthOf = (line: Line): number =>
  line.reduce((sum, point, i) => (i === 0 ? 0 : sum + gap(line[i - 1]!, point)), 0);

/** Where a place on the line is, measured along it from its beginning. */
export const arcAt = (line: Line, { segment, point }: Pick<OnLine, 'segment' | 'point'>): number =>
  lengthOf(line.slice(0, segment + 1)) + gap(line[segment]!, point);

/** @returns the line's point nearest to `to`; `undefined` for a line without points */
export function nearestOn(line: Line, to: Vec3): OnLine | undefined {
  const [only] = line;
  if (line.length === 1) return { segment: 0, t: 0, point: only!, distance: gap(only!, to) };
  let best: OnLine | undefined;
  for (let segment = 0; segment + 1 < line.length; segment++) {
    const [a, b] = [line[segment]!, line[segment + 1]!];
    const along = subtract(b, a);
    const squared = dot(along, along);
    const t = squared > 0 ? Math.min(1, Math.max(0, dot(subtract(to, a), along) / squared)) : 0;
    const point = mix(a, b, t);
    const distance = gap(point, to);
    if (!best || distance < best.distance) best = { segment, t, point, distance };
  }
  return best;
}

/** The part of the line before a place on it, which becomes its end. */
export const upTo = (line: Line, { segment, point }: Pick<OnLine, 'segment' | 'point'>): Vec3[] =>
  joined(line.slice(0, segment + 1), [point]);

/** The part of the line behind a place on it, which becomes its beginning. */
export const from = (line: Line, { segment, point }: Pick<OnLine, 'segment' | 'point'>): Vec3[] =>
  joined([point], line.slice(segment + 1));

/** One line after the other; points that fall on the one before are left out. */
export function joined(...lines: readonly Line[]): Vec3[] {
  const out: Vec3[] = [];
  for (const point of lines.flat()) {
    const last = out.at(-1);
    if (!last || gap(last, point) > 0) out.push(point);
  }
  return out;
}

/** The line in segments of one length, as near to `step` as whole segments allow; its ends stay. */
export function resampled(line: Line, step: number): Vec3[] {
  const length = lengthOf(line);
  if (!(length > 0)) return line.slice(0, 1);
  const segments = Math.max(1, Math.round(length / step));
  const out: Vec3[] = [line[0]!];
  let behind = 0;
  let i = 0;
  for (let k = 1; k < segments; k++) {
    const wanted = (length * k) / segments;
    let here = gap(line[i]!, line[i + 1]!);
    while (behind + here < wanted && i + 2 < line.length) {
      behind += here;
      i++;
      here = gap(line[i]!, line[i + 1]!);
    }
    out.push(mix(line[i]!, line[i + 1]!, here > 0 ? (wanted - behind) / here : 0));
  }
  return [...out, line.at(-1)!];
}

/** Without the inner points that are nearer than `least` to the one before; its ends stay. */
export function thinned(line: Line, least: number): Vec3[] {
  const out = line.slice(0, 1);
  for (const point of line.slice(1, -1)) if (gap(out.at(-1)!, point) >= least) out.push(point);
  const end = line.at(-1)!;
  if (out.length > 1 && gap(out.at(-1)!, end) < least) out.pop();
  return line.length > 1 ? [...out, end] : out;
}

/** Takes the hand's tremor out: each pass puts half of every inner point on the middle of its neighbours. */
export function smoothed(line: Line, passes: number): Vec3[] {
  let out = [...line];
  for (let pass = 0; pass < passes; pass++) {
    const before = out;
    out = before.map((point, i) =>
      i === 0 || i === before.length - 1 ? point : mix(point, mix(before[i - 1]!, before[i + 1]!, 0.5), 0.5),
    );
  }
  return out;
}

/** Where two lines on the screen cross first, along `a`; `undefined` where they do not. */
export function crossing(a: Line, b: Line): { readonly onA: OnLine; readonly onB: OnLine } | undefined {
  for (let i = 0; i + 1 < a.length; i++)
    for (let j = 0; j + 1 < b.length; j++) {
      const [p, r] = [a[i]!, subtract(a[i + 1]!, a[i]!)];
      const [q, s] = [b[j]!, subtract(b[j + 1]!, b[j]!)];
      const across = r[0] * s[1] - r[1] * s[0];
      if (across === 0) continue;
      const to = subtract(q, p);
      const t = (to[0] * s[1] - to[1] * s[0]) / across;
      const u = (to[0] * r[1] - to[1] * r[0]) / across;
      if (t < 0 || t > 1 || u < 0 || u > 1) continue;
      const onA = { segment: i, t, point: mix(a[i]!, a[i + 1]!, t), distance: 0 };
      return { onA, onB: { segment: j, t: u, point: mix(b[j]!, b[j + 1]!, u), distance: 0 } };
    }
  return undefined;
}

/** Decimals that a recipe keeps of places on a thing of this size: steps of 1/200 to 1/2000 of it. */
export const placesFor = (size: number): number =>
  size > 0 && Number.isFinite(size) ? Math.min(12, Math.max(0, Math.ceil(Math.log10(200 / size)))) : 3;

/** Points as recipes hold them, so that screen, file and link have the same numbers; doubles are left out. */
export function quantised(line: Line, places: number): [number, number, number][] {
  const rounded = line.map((point) => point.map((x) => roundTo(x, places)) as [number, number, number]);
  return rounded.filter((point, i) => i === 0 || gap(point, rounded[i - 1]!) > 0);
}
