// Vertex sets as recipes write them: "all", a list, or ranges with both ends included.

export type VertexSet =
  | 'all'
  | readonly number[]
  | { readonly ranges: readonly (readonly [number, number])[] };

/** A set of its own, as a recipe takes it. */
export type OwnVertexSet = 'all' | number[] | { ranges: [number, number][] };

/**
 * The indices of a set over `count` vertices, ascending and without repeats. What lies beyond them is left out: whether
 * a set fits its model is for `firstOutside` to say. Takes memory for `count` indices at most, whatever is written.
 */
export function toIndices(set: VertexSet, count: number): Uint32Array {
  if (set === 'all') return Uint32Array.from({ length: count }, (_, i) => i);
  return 'ranges' in set ? fromRanges(set.ranges, count) : unique(set.filter((i) => i < count));
}

/** How many vertices of `count` a set names, counted without making a list of them. */
export function sizeOf(set: VertexSet, count: number): number {
  if (set === 'all') return count;
  return 'ranges' in set ? total(merged(set.ranges, count)) : toIndices(set, count).length;
}

/** Whether a set names nothing, told without looking through it. */
export const isEmpty = (set: VertexSet): boolean =>
  set !== 'all' && ('ranges' in set ? set.ranges.length === 0 : set.length === 0);

/** Whether a vertex is in a set, told without making a list of it. */
export function holds(set: VertexSet, vertex: number): boolean {
  if (set === 'all') return true;
  if ('ranges' in set) return set.ranges.some(([first, last]) => first <= vertex && vertex <= last);
  return set.includes(vertex);
}

/** The shortest recipe form of a set of indices (any order, repeats allowed) over `count` vertices. */
export function fromIndices(indices: Iterable<number>, count: number): OwnVertexSet {
  const sorted = unique([...indices]);
  if (sorted.length === count && count > 0) return 'all';
  const ranges: [number, number][] = [];
  for (const i of sorted) {
    const last = ranges.at(-1);
    if (last && last[1] === i - 1) last[1] = i;
    else ranges.push([i, i]);
  }
  return ranges.length * 2 < sorted.length ? { ranges } : [...sorted];
}

/** The first index at or beyond `count`, or `undefined` when all lie inside. Ranges are not expanded. */
export function firstOutside(set: VertexSet, count: number): number | undefined {
  if (set === 'all') return undefined;
  if ('ranges' in set) return set.ranges.find(([, last]) => last >= count)?.[1];
  return set.find((i) => i >= count);
}

type Ranges = Extract<VertexSet, { ranges: unknown }>['ranges'];

function fromRanges(ranges: Ranges, count: number): Uint32Array {
  const parts = merged(ranges, count);
  const out = new Uint32Array(total(parts));
  let at = 0;
  for (const [first, last] of parts) for (let i = first; i <= last; i++) out[at++] = i;
  return out;
}

/** Ascending ranges below `count` that neither overlap nor touch: twenty thousand times the same range is one. */
function merged(ranges: Ranges, count: number): [number, number][] {
  const out: [number, number][] = [];
  for (const [first, end] of [...ranges].sort((a, b) => a[0] - b[0])) {
    const last = Math.min(end, count - 1);
    if (first > last) continue;
    const before = out.at(-1);
    if (before && first <= before[1] + 1) before[1] = Math.max(before[1], last);
    else out.push([first, last]);
  }
  return out;
}

const total = (ranges: Ranges): number => ranges.reduce((sum, [first, last]) => sum + last - first + 1, 0);

function unique(indices: readonly number[]): Uint32Array {
  const sorted = Uint32Array.from(indices).sort();
  let kept = 0;
  for (const i of sorted) if (kept === 0 || sorted[kept - 1] !== i) sorted[kept++] = i;
  return sorted.slice(0, kept);
}
