// A line of the drawing in hand, pure: how much of it is meant, what stays beside it, the curve it becomes.

import { type Curve, MAX_HELD } from '../../../recipe/steps/curves';
import type { PenDrawing, PenHit } from '../../../view/overlays/types';
import type { Vec3 } from '../../../view/types';
import { gap, mix } from '../../geometry';
import { arcAt, type Line, lengthOf, nearestOn, resampled, smoothed } from '../../stroke/polyline';
import { kept } from '../edits';
import { splinePoints } from '../spline';

/** Shares of the model's largest extent: steps of a line, and how far its curve may be from it. */
const STEP = 1 / 300;
const TOLERANCE = 1 / 600;
/** Control points of a picked line, and of one that stays beside it. */
const CONTROLS = 24;
const HELD_CONTROLS = 10;
/** Of a long line so much is taken up at first, to either side of the click, in reaches; never less than this share of it. */
const TAKEN = 1.5;
/** Lines stay where they are nearer than the reach; what is nearer than this share of it goes along. */
const TOUCHING = 0.15;
/** What is left of a line when it is trimmed, in shares of the extent. */
const SHORTEST = 1 / 60;

export interface PickedLine {
  /** All of it as it runs on the surface, model space. */
  readonly line: Line;
  /** What is in hand of it: from and to, lengths along it. */
  readonly span: readonly [number, number];
  /** How far a pull goes, model units. */
  readonly reach: number;
  /** The other lines of the view. */
  readonly others: readonly Line[];
}

const pointsOfLine = ({ points, offsets }: Pick<PenDrawing, 'points' | 'offsets'>, line: number): Vec3[] => {
  const out: Vec3[] = [];
  for (let i = offsets[line]!; i < offsets[line + 1]!; i++)
    out.push([points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!]);
  return out;
};

/** @param size  the model's largest extent */
export function pickedFrom(
  drawing: Pick<PenDrawing, 'points' | 'offsets' | 'closed'>,
  hit: Pick<PenHit, 'line' | 'segment' | 'point'>,
  reach: number,
  size: number,
): PickedLine {
  const found = pointsOfLine(drawing, hit.line);
  // A ring is opened across from where it was picked.
  const across = (hit.segment + Math.floor(found.length / 2)) % found.length;
  const open = drawing.closed[hit.line] ? [...found.slice(across), ...found.slice(0, across + 1)] : found;
  // Between the edges of the mesh a line runs in small steps to and fro.
  const line = smoothed(resampled(open, STEP * size), 3);
  const others = Array.from({ length: drawing.offsets.length - 1 }, (_, i) => i)
    .filter((i) => i !== hit.line)
    .map((i) => {
      const other = pointsOfLine(drawing, i);
      return drawing.closed[i] ? [...other, other[0]!] : other;
    });
  const at = nearestOn(line, hit.point);
  return { line, span: spanAround(lengthOf(line), at ? arcAt(line, at) : 0, TAKEN * reach), reach, others };
}

/** The part of a line to either side of a place; all of it where little would be left over. */
export function spanAround(length: number, at: number, half: number): [number, number] {
  if (length <= 2.6 * half) return [0, length];
  const from = Math.min(Math.max(0, at - half), length - 2 * half);
  return [from, from + 2 * half];
}

/** The piece of a line between two lengths along it. */
export function partOf(line: Line, [from, to]: readonly [number, number]): Vec3[] {
  const out: Vec3[] = [];
  let before = 0;
  for (let i = 0; i + 1 < line.length; i++) {
    const [a, b] = [line[i]!, line[i + 1]!];
    const here = gap(a, b);
    const after = before + here;
    if (here > 0 && after >= from && before < to) {
      if (out.length === 0) out.push(mix(a, b, Math.max(0, (from - before) / here)));
      if (after > from) out.push(mix(a, b, Math.min(1, (to - before) / here)));
    }
    before = after;
  }
  return out.length > 1 ? out : [line[0]!, line.at(-1)!];
}

/** Half way along. */
export const middleOf = (line: Line): Vec3 => partOf(line, [0, lengthOf(line) / 2]).at(-1)!;

/** With one end elsewhere along the line. */
export function trimmedAt(
  picked: PickedLine,
  end: 'start' | 'end',
  to: number,
  size: number,
): readonly [number, number] {
  const [from, till] = picked.span;
  const length = lengthOf(picked.line);
  const least = Math.min(SHORTEST * size, length);
  return end === 'start'
    ? [Math.min(Math.max(0, to), till - least), till]
    : [from, Math.max(Math.min(length, to), from + least)];
}

/** Where along the line the pointer is nearest to it. @param seen  the line's points on the screen, CSS pixels */
export function arcUnder(
  line: Line,
  seen: readonly { readonly x: number; readonly y: number }[],
  x: number,
  y: number,
): number {
  const flat = seen.map((at): Vec3 => [at.x, at.y, 0]);
  const near = nearestOn(flat, [x, y, 0]);
  if (!near) return 0;
  const { segment, t } = near;
  return arcAt(line, {
    segment,
    point: mix(line[segment]!, line[Math.min(segment + 1, line.length - 1)]!, t),
  });
}

/** As few control points, at even steps, as keep the curve on the line. */
export function controlsOf(line: Line, tolerance: number, most: number): Vec3[] {
  const length = lengthOf(line);
  for (let count = 2; ; count++) {
    const controls = resampled(line, length / (count - 1));
    if (count >= most) return controls;
    const curve = splinePoints(controls, [], 6);
    if (line.every((point) => nearestOn(curve, point)!.distance <= tolerance)) return controls;
  }
}

/** The pieces of other lines that stay when the picked one is pulled, control points each; the nearest first. */
export function heldBeside(part: Line, others: readonly Line[], reach: number, size: number): Vec3[][] {
  const [low, high] = [0, 1].map((side) =>
    [0, 1, 2].map((k) => {
      const along = part.map((point) => point[k]!);
      return side === 0 ? Math.min(...along) - reach : Math.max(...along) + reach;
    }),
  ) as [number[], number[]];
  const beside = (point: Vec3): number =>
    point.every((x, k) => x >= low[k]! && x <= high[k]!) ? nearestOn(part, point)!.distance : Infinity;
  const pieces: { readonly line: Vec3[]; readonly distance: number }[] = [];
  for (const other of others) {
    let run: Vec3[] = [];
    let distance = Infinity;
    const end = (): void => {
      if (run.length > 1 && lengthOf(run) > SHORTEST * size) pieces.push({ line: run, distance });
      run = [];
      distance = Infinity;
    };
    for (const point of other) {
      const away = beside(point);
      if (away < TOUCHING * reach || away > reach) end();
      else {
        run.push(point);
        distance = Math.min(distance, away);
      }
    }
    end();
  }
  return pieces
    .sort((a, b) => a.distance - b.distance)
    .slice(0, MAX_HELD)
    .map(({ line }) =>
      controlsOf(smoothed(resampled(line, STEP * size), 3), 2 * TOLERANCE * size, HELD_CONTROLS),
    );
}

/** The curve that a picked line is in a recipe. @param hold  whether the lines beside it stay */
export function curveOf(picked: PickedLine, id: string, hold: boolean, size: number): Curve {
  const part = partOf(picked.line, picked.span);
  const held = hold ? heldBeside(part, picked.others, picked.reach, size) : [];
  return {
    id,
    kind: 'contour',
    rest: controlsOf(part, TOLERANCE * size, CONTROLS).map((point) => kept(point, size)),
    reach: keptLength(picked.reach, size),
    ...(held.length > 0 && { held: held.map((line) => line.map((point) => kept(point, size))) }),
  };
}

const keptLength = (length: number, size: number): number => Math.max(kept([length, 0, 0], size)[0], 1e-12);

/** A line that a recipe has, in hand again: there is no more of it than its curve. */
export function pickedOf({ rest, reach, held }: Curve, usual: number): PickedLine {
  const line = splinePoints(rest);
  const others = (held ?? []).map((controls) => splinePoints(controls));
  return { line, span: [0, lengthOf(line)], reach: reach ?? usual, others };
}
