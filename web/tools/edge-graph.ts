// Edges of a surface between its places: how sharp each is, what it goes on as, and the shortest way along them.

import { cross, dot, norm, pointAt, subtract, unit } from './geometry';
import { buckets, type GraphSource } from './mesh-graph';
import { NearestFirst } from './nearest-first';

export interface EdgeSource extends GraphSource {
  /** 3 per source vertex. */
  readonly positions: Float64Array;
  /** Source face of each triangle: edges inside one are nobody's. */
  readonly faceOfTriangle: Uint32Array;
}

/** Degrees: below, an edge is part of something smooth. */
export const BENT = 15;
/** Degrees: where a line of edges turns by more it has a corner, as in the kernel. */
const TURN = 60;
/** What an edge of this many degrees costs less than its length, at most by that share. */
const CREASE = 40;
const CHEAPER = 0.6;

/** An edge by its number; vertices are source vertices, of copies the first. */
export class EdgeGraph {
  /** Two places per edge. */
  readonly #ends: Uint32Array;
  /** Degrees between the triangles of each; 180 where three or more meet, 0 at a border. */
  readonly #angles: Float32Array;
  /** Edges at place p: `#at[#start[p]]` to `#at[#start[p + 1]]`. */
  readonly #start: Uint32Array;
  readonly #at: Uint32Array;
  readonly #vertexOf: Uint32Array;
  readonly #placeOf: Int32Array;
  readonly #positions: Float64Array;

  constructor({ positions, triangles, welded, faceOfTriangle }: EdgeSource) {
    this.#positions = positions;
    this.#placeOf = welded;
    const places = welded.reduce((most, place) => Math.max(most, place + 1), 0);
    this.#vertexOf = new Uint32Array(places);
    for (let v = welded.length - 1; v >= 0; v--) if (welded[v]! >= 0) this.#vertexOf[welded[v]!] = v;
    const sides = sidesOf(triangles, welded, places);
    const ends: number[] = [];
    const angles: number[] = [];
    const normalOf = (t: number) => normal(positions, triangles, t);
    for (let first = 0, last = 0; first < sides.length; first = last) {
      while (last < sides.length && sides.key(last) === sides.key(first)) last++;
      const [t, other] = [sides.triangle(first), sides.triangle(Math.min(first + 1, last - 1))];
      if (last - first === 2 && faceOfTriangle[t] === faceOfTriangle[other]) continue;
      ends.push(Math.floor(sides.key(first) / places), sides.key(first) % places);
      angles.push(last - first > 2 ? 180 : last - first < 2 ? 0 : between(normalOf(t), normalOf(other)));
    }
    this.#ends = Uint32Array.from(ends);
    this.#angles = Float32Array.from(angles);
    [this.#start, this.#at] = buckets(
      places,
      ends.length,
      (i) => ends[i]!,
      (i) => i >> 1,
    );
  }

  angleOf(edge: number): number {
    return this.#angles[edge]!;
  }

  verticesOf(edge: number): [number, number] {
    return [this.#vertexOf[this.#ends[2 * edge]!]!, this.#vertexOf[this.#ends[2 * edge + 1]!]!];
  }

  /** Of copies of one point the one that rows are made of. */
  firstCopy(vertex: number): number {
    const place = this.#placeOf[vertex] ?? -1;
    return place < 0 ? vertex : this.#vertexOf[place]!;
  }

  edgesAt(vertex: number): Uint32Array {
    const place = this.#placeOf[vertex] ?? -1;
    return place < 0 ? new Uint32Array() : this.#edgesOf(place);
  }

  /**
   * The line of edges that one is part of: on to where other than two as sharp meet, or where it turns.
   *
   * @returns source vertices along it; of a closed one the first stands last again
   */
  chain(edge: number): number[] {
    const [a, b] = [this.#ends[2 * edge]!, this.#ends[2 * edge + 1]!];
    const least = Math.max(BENT, this.#angles[edge]! / 2);
    if (this.#angles[edge]! < BENT) return this.verticesOf(edge);
    const on = this.#onwards(edge, b, least);
    if (on.at(-1) === a) return [a, b, ...on].map((place) => this.#vertexOf[place]!);
    const back = this.#onwards(edge, a, least);
    return [...back.reverse(), a, b, ...on].map((place) => this.#vertexOf[place]!);
  }

  /**
   * The shortest way along edges (E. W. Dijkstra, 1959).
   *
   * @param creases  whether sharp edges count as shorter, so that a way near one keeps to it
   * @returns source vertices from the first to the last; `null`: no edges lead there
   */
  path(from: number, to: number, creases: boolean): number[] | null {
    const [start, goal] = [this.#placeOf[from] ?? -1, this.#placeOf[to] ?? -1];
    if (start < 0 || goal < 0) return null;
    const before = new Map<number, number>([[start, -1]]);
    const costs = new Map<number, number>([[start, 0]]);
    const waiting = new NearestFirst();
    waiting.push(start, 0);
    const done = new Set<number>();
    for (let nearest = waiting.pop(); nearest && nearest[0] !== goal; nearest = waiting.pop()) {
      const [place] = nearest;
      if (done.has(place)) continue;
      done.add(place);
      for (const edge of this.#edgesOf(place)) {
        const next = this.#across(edge, place);
        const cost = costs.get(place)! + this.#cost(edge, creases);
        if (cost >= (costs.get(next) ?? Number.POSITIVE_INFINITY)) continue;
        costs.set(next, cost);
        before.set(next, place);
        waiting.push(next, cost);
      }
    }
    if (!before.has(goal)) return null;
    const way: number[] = [];
    for (let place = goal; place >= 0; place = before.get(place)!) way.push(this.#vertexOf[place]!);
    return way.reverse();
  }

  /** Places that the line of an edge goes on to beyond one of its ends. */
  #onwards(edge: number, end: number, least: number): number[] {
    const first = this.#across(edge, end);
    const way: number[] = [];
    for (let [along, at] = [edge, end]; at !== first; ) {
      const next = this.#edgesOf(at).filter((each) => each !== along && this.#angles[each]! >= least);
      if (next.length !== 1) break;
      const on = this.#across(next[0]!, at);
      const turn = between(this.#leg(this.#across(along, at), at), this.#leg(at, on));
      if (turn > TURN) break;
      way.push(on);
      [along, at] = [next[0]!, on];
    }
    return way;
  }

  #edgesOf(place: number): Uint32Array {
    return this.#at.subarray(this.#start[place], this.#start[place + 1]);
  }

  #across(edge: number, place: number): number {
    return this.#ends[2 * edge]! === place ? this.#ends[2 * edge + 1]! : this.#ends[2 * edge]!;
  }

  #leg(from: number, to: number) {
    const at = (place: number) => pointAt(this.#positions, this.#vertexOf[place]!);
    return unit(subtract(at(to), at(from)));
  }

  #cost(edge: number, creases: boolean): number {
    const [a, b] = this.verticesOf(edge);
    const length = norm(subtract(pointAt(this.#positions, a), pointAt(this.#positions, b)));
    return creases ? length * (1 - CHEAPER * Math.min(1, this.#angles[edge]! / CREASE)) : length;
  }
}

const between = (a: readonly [number, number, number], b: readonly [number, number, number]): number =>
  norm(a) > 0 && norm(b) > 0 ? (Math.acos(Math.min(1, Math.max(-1, dot(a, b)))) * 180) / Math.PI : 0;

function normal(positions: Float64Array, triangles: Uint32Array, t: number) {
  const at = (corner: number) => pointAt(positions, triangles[3 * t + corner]!);
  return unit(cross(subtract(at(1), at(0)), subtract(at(2), at(0))));
}

/** Sides of triangles, those of one edge beside each other. */
function sidesOf(triangles: Uint32Array, welded: Int32Array, places: number) {
  const keys = new Float64Array(triangles.length);
  let length = 0;
  const order = new Uint32Array(triangles.length);
  for (let i = 0; i < triangles.length; i++) {
    const a = welded[triangles[i]!]!;
    const b = welded[triangles[i % 3 === 2 ? i - 2 : i + 1]!]!;
    if (a < 0 || b < 0 || a === b) continue;
    keys[i] = Math.min(a, b) * places + Math.max(a, b);
    order[length++] = i;
  }
  const sorted = order.subarray(0, length).sort((i, j) => keys[i]! - keys[j]! || i - j);
  return {
    length,
    key: (at: number) => keys[sorted[at]!]!,
    triangle: (at: number) => Math.floor(sorted[at]! / 3),
  };
}
