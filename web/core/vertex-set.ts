// Vertex sets as recipes write them: "all", a list, or ranges with both ends included.

export type VertexSet =
  | 'all'
  | readonly number[]
  | { readonly ranges: readonly (readonly [number, number])[] };

/** A set of its own, as a recipe takes it. */
export type OwnVertexSet = 'all' | number[] | { ranges: [number, number][] };

/** The indices of a set over `count` vertices, ascending and without repeats. Does not check the range. */
export function toIndices(set: VertexSet, count: number): Uint32Array {
  if (set === 'all') return Uint32Array.from({ length: count }, (_, i) => i);
  if ('ranges' in set) {
    const out: number[] = [];
    for (const [first, last] of set.ranges) for (let i = first; i <= last; i++) out.push(i);
    return unique(out);
  }
  return unique(set);
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

function unique(indices: readonly number[]): Uint32Array {
  return Uint32Array.from(new Set(indices)).sort();
}
