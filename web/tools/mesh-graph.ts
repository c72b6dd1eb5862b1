/** What the graph is built from: the kernel's triangles and weld map over source vertices. */
export interface GraphSource {
  readonly triangles: Uint32Array;
  /** Per source vertex its welded vertex, −1 none. */
  readonly welded: Int32Array;
}

/**
 * Who is whose neighbour on the surface. Copies of one point (STL soup, glTF seams) are one place:
 * a walk crosses seams, and a set of vertices is always completed by their copies.
 */
export class MeshGraph {
  /** Neighbours of place p: `#near[#start[p]]` to `#near[#start[p + 1]]`, places. */
  readonly #start: Uint32Array;
  readonly #near: Uint32Array;
  /** Source vertices of place p, likewise. */
  readonly #copyStart: Uint32Array;
  readonly #copies: Uint32Array;
  readonly #place: Int32Array;

  constructor({ triangles, welded }: GraphSource) {
    this.#place = welded;
    const places = welded.reduce((most, place) => Math.max(most, place + 1), 0);
    [this.#copyStart, this.#copies] = buckets(
      places,
      welded.length,
      (i) => welded[i]!,
      (i) => i,
    );
    const corner = (i: number): number => welded[triangles[i]!]!;
    const next = (i: number): number => (i % 3 === 2 ? i - 2 : i + 1);
    const edges = 2 * triangles.length;
    const from = (e: number): number => corner(e % 2 ? next(e >> 1) : e >> 1);
    const to = (e: number): number => corner(e % 2 ? e >> 1 : next(e >> 1));
    [this.#start, this.#near] = buckets(places, edges, from, to);
  }

  /** Source vertices, whether they are a place or not. */
  get vertexCount(): number {
    return this.#place.length;
  }

  /** The vertices together with all copies of them, ascending. */
  withCopies(vertices: Iterable<number>): Uint32Array {
    const out = new Set<number>();
    for (const v of vertices) {
      const place = this.#place[v] ?? -1;
      if (place < 0) continue;
      for (let i = this.#copyStart[place]!; i < this.#copyStart[place + 1]!; i++) out.add(this.#copies[i]!);
    }
    return Uint32Array.from(out).sort();
  }

  /** One file vertex of each place that an edge joins to this one. */
  neighbours(vertex: number): number[] {
    const place = this.#place[vertex] ?? -1;
    if (place < 0) return [];
    const near = this.#near.subarray(this.#start[place], this.#start[place + 1]);
    return [...new Set(near)].map((each) => this.#copies[this.#copyStart[each]!]!);
  }

  /** All vertices reached from `seed` over edges through vertices where `passable` holds, ascending. */
  flood(seed: number, passable: (vertex: number) => boolean): Uint32Array {
    const first = this.#place[seed] ?? -1;
    if (first < 0 || !passable(seed)) return new Uint32Array();
    const seen = new Set([first]);
    const waiting = [first];
    for (let place = waiting.pop(); place !== undefined; place = waiting.pop())
      for (let i = this.#start[place]!; i < this.#start[place + 1]!; i++) {
        const near = this.#near[i]!;
        if (seen.has(near) || !passable(this.#copies[this.#copyStart[near]!]!)) continue;
        seen.add(near);
        waiting.push(near);
      }
    return this.withCopies([...seen].map((place) => this.#copies[this.#copyStart[place]!]!));
  }
}

/** `value(i)` for i below `count`, sorted into `buckets` by `bucket(i)`: offsets and values. −1 is left out. */
export function buckets(
  size: number,
  count: number,
  bucket: (i: number) => number,
  value: (i: number) => number,
): [Uint32Array, Uint32Array] {
  const start = new Uint32Array(size + 1);
  let kept = 0;
  for (let i = 0; i < count; i++) {
    const b = bucket(i);
    if (b < 0) continue;
    start[b + 1]!++;
    kept++;
  }
  for (let b = 0; b < size; b++) start[b + 1]! += start[b]!;
  const at = start.slice();
  const values = new Uint32Array(kept);
  for (let i = 0; i < count; i++) {
    const b = bucket(i);
    if (b >= 0) values[at[b]!++] = value(i);
  }
  return [start, values];
}
