// How a pen would draw lines: contours strong, suggestive ones fine, all of them running out at their ends.

import { MathUtils } from 'three';
import type { Segments } from './segments';
import type { PenDrawing } from './types';

/** CSS pixels. */
const STRONG = 2.3;
const FINE = 1.5;
/** Over this part of a line, and no more than so far in drawn units, it runs out. */
const TAPER = 0.3;
const LONGEST_TAPER = 0.14;
/** What is left at the very end: of its width, and of its blackness. */
const LEAST_WIDTH = 0.45;
const LEAST_INK = 0.25;
/** Blackness of fine lines. */
const FINE_INK = 0.82;
/** From edge to edge of the mesh fine lines tremble: a hand would not. */
const CALMING = 4;

/**
 * @param places  of the drawing's points, drawn units; those of fine lines are calmed
 * @param ink     display colour
 */
export function penStrokes(
  { offsets, suggestive, closed }: Pick<PenDrawing, 'offsets' | 'suggestive' | 'closed'>,
  places: Float32Array,
  ink: readonly [number, number, number],
): Segments {
  let count = 0;
  for (let line = 0; line + 1 < offsets.length; line++)
    count += offsets[line + 1]! - offsets[line]! - (closed[line] ? 0 : 1);
  const ends = new Float32Array(6 * count);
  const looks = new Float32Array(4 * count);
  let at = 0;
  const joined = joints(offsets, places);
  for (let line = 0; line + 1 < offsets.length; line++) {
    const [first, end] = [offsets[line]!, offsets[line + 1]!];
    const pieces = end - first - (closed[line] ? 0 : 1);
    if (suggestive[line] && !closed[line]) calm(places.subarray(3 * first, 3 * end));
    const lengths = new Float32Array(pieces);
    let whole = 0;
    for (let i = 0; i < pieces; i++) {
      const [a, b] = [3 * (first + i), 3 * (i + 1 < end - first ? first + i + 1 : first)];
      for (let k = 0; k < 3; k++) {
        ends[6 * (at + i) + k] = places[a + k]!;
        ends[6 * (at + i) + 3 + k] = places[b + k]!;
      }
      lengths[i] = Math.hypot(
        places[b]! - places[a]!,
        places[b + 1]! - places[a + 1]!,
        places[b + 2]! - places[a + 2]!,
      );
      whole += lengths[i]!;
    }
    const taper = closed[line] ? 0 : Math.min(TAPER * whole, LONGEST_TAPER);
    const width = suggestive[line] ? FINE : STRONG;
    const black = suggestive[line] ? FINE_INK : 1;
    // Where a line goes on as another one, it does not run out.
    const [fromStart, fromEnd] = [first, end - 1].map((i) => (joined.has(keyOf(places, i)) ? Infinity : 0));
    let before = 0;
    for (let i = 0; i < pieces; i++, at++) {
      const middle = before + lengths[i]! / 2;
      before += lengths[i]!;
      const away = Math.min(middle + fromStart!, whole - middle + fromEnd!);
      const x = taper > 0 ? Math.min(1, away / taper) : 1;
      const full = MathUtils.smoothstep(x, 0, 1);
      const cover = black * (LEAST_INK + (1 - LEAST_INK) * full);
      for (let k = 0; k < 3; k++) looks[4 * at + k] = 1 - cover * (1 - ink[k]!);
      looks[4 * at + 3] = width * (LEAST_WIDTH + (1 - LEAST_WIDTH) * full);
    }
  }
  return { ends, looks };
}

const keyOf = (places: Float32Array, i: number): string =>
  `${places[3 * i]} ${places[3 * i + 1]} ${places[3 * i + 2]}`;

/** Places where two lines end: one that was split there. */
function joints(offsets: Uint32Array, places: Float32Array): Set<string> {
  const once = new Set<string>();
  const twice = new Set<string>();
  for (let line = 0; line + 1 < offsets.length; line++)
    for (const i of [offsets[line]!, offsets[line + 1]! - 1]) {
      const key = keyOf(places, i);
      (once.has(key) ? twice : once).add(key);
    }
  return twice;
}

/** Each pass puts half of every inner point on the middle of its neighbours. */
function calm(line: Float32Array): void {
  for (let pass = 0; pass < CALMING; pass++) {
    const before = line.slice();
    for (let i = 3; i < line.length - 3; i++)
      line[i] = before[i]! / 2 + (before[i - 3]! + before[i + 3]!) / 4;
  }
}
