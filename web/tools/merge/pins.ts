// Pins: pairs of vertices, one on either loop of a boundary, that come to lie on each other (Fu 3.3.2). Between two
// pins the loops correspond by arc length. Pins of a step are numbered through, boundary by boundary.

import type { MergeStep } from '../../recipe/recipe';
import { arcLengths, indexAt, type Loop } from './loops';

export type MergeSide = 'source' | 'target';
export type MergeBoundary = MergeStep['boundaries'][number];
export type Key = readonly [source: number, target: number];

/** Place of a side in a key. */
export const slot = (side: MergeSide): 0 | 1 => (side === 'source' ? 0 : 1);
export const otherSide = (side: MergeSide): MergeSide => (side === 'source' ? 'target' : 'source');

export interface Pin {
  /** Its number in the step, from 0. */
  readonly number: number;
  readonly boundary: number;
  /** Its place among the boundary's keys. */
  readonly key: number;
  readonly vertices: Key;
}

/** @param found  keys the last merge worked with, for boundaries that have none of their own */
export function pinsOf(
  boundaries: readonly Pick<MergeBoundary, 'keys'>[],
  found: readonly (readonly Key[])[] = [],
): Pin[] {
  return boundaries
    .flatMap(({ keys }, boundary) =>
      (keys.length > 0 ? keys : (found[boundary] ?? [])).map((vertices, key) => ({
        boundary,
        key,
        vertices,
      })),
    )
    .map((pin, number) => ({ number, ...pin }));
}

/** The boundaries with the keys that were found written down, so that they can be moved. */
export const withFoundKeys = (
  boundaries: readonly MergeBoundary[],
  found: readonly (readonly Key[])[],
): MergeBoundary[] =>
  boundaries.map((boundary, i) =>
    boundary.keys.length > 0 ? boundary : { ...boundary, keys: (found[i] ?? []).map(([s, t]) => [s, t]) },
  );

export const removeKey = (boundary: MergeBoundary, key: number): MergeBoundary => ({
  ...boundary,
  keys: boundary.keys.filter((_, i) => i !== key),
});

/**
 * The boundary with one end of a key elsewhere on its loop. A key never passes its neighbours and never shares a
 * vertex with one: it stops beside them.
 */
export function moveKey(
  boundary: MergeBoundary,
  key: number,
  side: MergeSide,
  vertex: number,
): MergeBoundary {
  const loop = boundary[side];
  const held = boundary.keys[key];
  const to = loop.indexOf(vertex);
  if (!held || to < 0) return boundary;
  const from = loop.indexOf(held[slot(side)]);
  const others = boundary.keys.filter((_, i) => i !== key).map((each) => loop.indexOf(each[slot(side)]));
  const at = others.length > 0 ? between(from, to, others, loop.length) : to;
  const moved: [number, number] = side === 'source' ? [loop[at]!, held[1]] : [held[0], loop[at]!];
  return { ...boundary, keys: boundary.keys.map((each, i) => (i === key ? moved : each)) };
}

/** The place nearest to `to` that can be reached from `from` without meeting one of the others. */
function between(from: number, to: number, others: readonly number[], count: number): number {
  const ahead = (place: number) => (place - from + count) % count;
  const behind = (place: number) => (from - place + count) % count;
  const forward = Math.min(...others.map(ahead)) - 1;
  const back = Math.min(...others.map(behind)) - 1;
  if (ahead(to) <= forward || behind(to) <= back) return to;
  const [beyondAhead, beyondBack] = [ahead(to) - forward, behind(to) - back];
  return beyondAhead < beyondBack ? (from + forward) % count : (from - back + count) % count;
}

/** Shapes of the two models, for lengths along their loops. */
export type SidePositions = Readonly<Record<MergeSide, Float64Array>>;

/** The boundary with one key more, at `vertex` of a side; its partner lies where arc length says. */
export function addKey(
  boundary: MergeBoundary,
  side: MergeSide,
  vertex: number,
  positions: SidePositions,
): MergeBoundary {
  const own = boundary[side];
  if (!own.includes(vertex) || boundary.keys.some((key) => key[slot(side)] === vertex)) return boundary;
  const partner = partnerOf(boundary, side, vertex, positions);
  if (partner === undefined) return boundary;
  const key: [number, number] = side === 'source' ? [vertex, partner] : [partner, vertex];
  const keys = [...boundary.keys, key];
  // In the order of the source's loop, which is the order their numbers follow.
  const order = new Map(boundary.source.map((each, i) => [each, i]));
  return { ...boundary, keys: keys.sort((a, b) => order.get(a[0])! - order.get(b[0])!) };
}

/** Where a vertex of one loop comes to lie on the other; undefined where the keys around it leave no vertex free. */
export function partnerOf(
  boundary: MergeBoundary,
  side: MergeSide,
  vertex: number,
  positions: SidePositions,
): number | undefined {
  const other = otherSide(side);
  const [own, across] = [
    measured(boundary[side], positions[side]),
    measured(boundary[other], positions[other]),
  ];
  const keys = boundary.keys.map((key) => ({
    own: own.at(key[slot(side)]),
    across: across.at(key[slot(other)]),
  }));
  const at = own.at(vertex);
  if (keys.length === 0) return across.loop[0];
  // Both loops have what is kept to their left, so they run against each other where they meet.
  const after = keys.toSorted((a, b) => ahead(at, a.own, own.whole) - ahead(at, b.own, own.whole))[0]!;
  const before = keys.toSorted((a, b) => ahead(a.own, at, own.whole) - ahead(b.own, at, own.whole))[0]!;
  const span = ahead(before.own, after.own, own.whole) || own.whole;
  const spanAcross = ahead(after.across, before.across, across.whole) || across.whole;
  const share = ahead(before.own, at, own.whole) / span;
  const found = across.loop[indexAt(across.lengths, before.across - share * spanAcross)]!;
  return boundary.keys.some((key) => key[slot(other)] === found) ? undefined : found;
}

const ahead = (from: number, to: number, whole: number): number => (to - from + whole) % whole;

function measured(loop: Loop, positions: Float64Array) {
  const lengths = arcLengths(loop, positions);
  return {
    loop,
    lengths,
    whole: lengths[loop.length]!,
    at: (vertex: number) => lengths[loop.indexOf(vertex)]!,
  };
}
