// Which triangles meet at a welded vertex, and floods over them.

/** Squared distance from p to the segment ab. */
export function segmentDistance2(x: Float64Array, a: number, b: number, p: readonly number[]): number {
  const [px, py, pz] = p as [number, number, number];
  const ax = x[3 * a]!;
  const ay = x[3 * a + 1]!;
  const az = x[3 * a + 2]!;
  const ux = x[3 * b]! - ax;
  const uy = x[3 * b + 1]! - ay;
  const uz = x[3 * b + 2]! - az;
  const uu = ux * ux + uy * uy + uz * uz;
  const along = uu > 0 ? ((px - ax) * ux + (py - ay) * uy + (pz - az) * uz) / uu : 0;
  const t = Math.min(1, Math.max(0, along));
  return (ax + t * ux - px) ** 2 + (ay + t * uy - py) ** 2 + (az + t * uz - pz) ** 2;
}

/** How many edges away from a border a soft mask is smoothed. */
const REACH = 4;

export class SurfaceGraph {
  readonly #triangles: Uint32Array;
  /** Welded vertex per source vertex; those of no triangle share the last, which has none either. */
  readonly #welded: Uint32Array;
  readonly #offsets: Uint32Array;
  readonly #around: Uint32Array;
  #round = 0;
  readonly #seenTriangle: Uint32Array;
  readonly #seenVertex: Uint32Array;

  /**
   * @param triangles  3 source vertices each
   * @param welded     welded vertex per source vertex, −1 none
   */
  constructor(triangles: Uint32Array, welded: Int32Array) {
    let count = 0;
    for (const w of welded) if (w >= count) count = w + 1;
    this.#triangles = triangles;
    this.#welded = Uint32Array.from(welded, (w) => (w < 0 ? count : w));
    this.#offsets = new Uint32Array(count + 2);
    for (const v of triangles) this.#offsets[this.#welded[v]! + 1]!++;
    for (let w = 0; w <= count; w++) this.#offsets[w + 1]! += this.#offsets[w]!;
    const next = this.#offsets.slice();
    this.#around = new Uint32Array(triangles.length);
    for (let i = 0; i < triangles.length; i++) {
      this.#around[next[this.#welded[triangles[i]!]!]!++] = Math.floor(i / 3);
    }
    this.#seenTriangle = new Uint32Array(triangles.length / 3);
    this.#seenVertex = new Uint32Array(welded.length);
  }

  /**
   * Source vertices inside a ball that the surface joins to the triangle `start` without leaving it. The
   * twins of a seam come along.
   *
   * @param x  3 per source vertex; `centre` and `radius` in the same unit
   */
  verticesInBall(
    x: Float64Array,
    start: number,
    centre: readonly [number, number, number],
    radius: number,
  ): Uint32Array {
    const round = ++this.#round;
    const triangles = this.#triangles;
    const r2 = radius * radius;
    const found: number[] = [];
    const queue = [start];
    this.#seenTriangle[start] = round;
    const inside = (v: number): boolean =>
      (x[3 * v]! - centre[0]) ** 2 + (x[3 * v + 1]! - centre[1]) ** 2 + (x[3 * v + 2]! - centre[2]) ** 2 <=
      r2;
    for (let t = queue.pop(); t !== undefined; t = queue.pop()) {
      const corners = [triangles[3 * t]!, triangles[3 * t + 1]!, triangles[3 * t + 2]!] as const;
      const isIn = [inside(corners[0]), inside(corners[1]), inside(corners[2])];
      for (let k = 0; k < 3; k++) {
        const v = corners[k]!;
        if (isIn[k]) {
          if (this.#seenVertex[v] === round) continue;
          this.#seenVertex[v] = round;
          found.push(v);
          this.#enqueue(queue, v, undefined);
        } else {
          const w = corners[(k + 1) % 3]!;
          if (!isIn[(k + 1) % 3] && segmentDistance2(x, v, w, centre) <= r2) this.#enqueue(queue, v, w);
        }
      }
    }
    return Uint32Array.from(found).sort();
  }

  /** Adds the unseen triangles around v, or those of them that also meet w. */
  #enqueue(queue: number[], v: number, w: number | undefined): void {
    const triangles = this.#triangles;
    const a = this.#welded[v]!;
    const b = w === undefined ? undefined : this.#welded[w]!;
    for (let i = this.#offsets[a]!; i < this.#offsets[a + 1]!; i++) {
      const t = this.#around[i]!;
      if (this.#seenTriangle[t] === this.#round) continue;
      if (b !== undefined && !this.#meets(triangles, t, b)) continue;
      this.#seenTriangle[t] = this.#round;
      queue.push(t);
    }
  }

  #meets(triangles: Uint32Array, t: number, b: number): boolean {
    for (let k = 0; k < 3; k++) if (this.#welded[triangles[3 * t + k]!] === b) return true;
    return false;
  }

  /**
   * A 0–1 field that is above a half on the set and below it elsewhere, and whose level line at a half runs
   * more smoothly than the edges of the mesh do.
   *
   * @param set  source vertices
   * @returns the vertices where the field is not 0, and the field there
   */
  softMask(set: Uint32Array): { vertices: Uint32Array; values: Float32Array } {
    const hard = new Uint8Array(this.#offsets.length - 1);
    for (const v of set) hard[this.#welded[v]!] = 1;
    const field = Float32Array.from(hard);
    // Away from the border nothing changes.
    const near = this.#grow(this.#border(set, hard), REACH);
    const next = new Float32Array(near.length);
    for (let pass = 0; pass < REACH; pass++) {
      near.forEach((w, i) => {
        const mean = this.#mean(w, field);
        next[i] = hard[w] ? Math.max(0.54, mean) : Math.min(0.46, mean);
      });
      near.forEach((w, i) => {
        field[w] = next[i]!;
      });
    }
    const vertices = new Uint32Array(this.#welded.length);
    let count = 0;
    for (let v = 0; v < vertices.length; v++) if (field[this.#welded[v]!]! > 0) vertices[count++] = v;
    const found = vertices.slice(0, count);
    return { vertices: found, values: Float32Array.from(found, (v) => field[this.#welded[v]!]!) };
  }

  /** The mean over the corners of the triangles at w: itself a third, its neighbours the rest. */
  #mean(w: number, field: Float32Array): number {
    let sum = 0;
    let corners = 0;
    for (let i = this.#offsets[w]!; i < this.#offsets[w + 1]!; i++) {
      const t = 3 * this.#around[i]!;
      for (let k = 0; k < 3; k++) {
        sum += field[this.#welded[this.#triangles[t + k]!]!]!;
        corners++;
      }
    }
    return corners > 0 ? sum / corners : field[w]!;
  }

  /** The welded vertices of a set that have a neighbour outside it. `hard` is 1 on the set. */
  #border(set: Uint32Array, hard: Uint8Array): number[] {
    const out = new Set<number>();
    for (const v of set) {
      const w = this.#welded[v]!;
      for (let i = this.#offsets[w]!; i < this.#offsets[w + 1]!; i++) {
        const t = 3 * this.#around[i]!;
        for (let k = 0; k < 3; k++) if (!hard[this.#welded[this.#triangles[t + k]!]!]) out.add(w);
      }
    }
    return [...out];
  }

  /** Welded vertices up to `rings` edges away from some, those included. */
  #grow(from: readonly number[], rings: number): number[] {
    const seen = new Uint8Array(this.#offsets.length - 1);
    const out: number[] = [];
    const add = (w: number): void => {
      if (!seen[w]) out.push(w);
      seen[w] = 1;
    };
    for (const w of from) add(w);
    let at = 0;
    for (let ring = 0; ring < rings; ring++) {
      for (const to = out.length; at < to; at++) {
        const w = out[at]!;
        for (let i = this.#offsets[w]!; i < this.#offsets[w + 1]!; i++) {
          const t = 3 * this.#around[i]!;
          for (let k = 0; k < 3; k++) add(this.#welded[this.#triangles[t + k]!]!);
        }
      }
    }
    return out;
  }

  /** Whether two sets of source vertices share a welded vertex or an edge joins them. */
  touching(a: Uint32Array, b: Uint32Array): boolean {
    const inB = new Uint8Array(this.#offsets.length - 1);
    for (const v of b) inB[this.#welded[v]!] = 1;
    const own = Array.from(a, (v) => this.#welded[v]!);
    return this.#grow(own, 1).some((w) => inB[w] === 1);
  }
}
