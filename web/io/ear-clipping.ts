// Polygons cut into triangles by clipping ears, the shortest cut first: no slivers where there is a choice.

/** A corner this close to straight (sine of its turn) is no ear: its triangle would have no area. */
const STRAIGHT = 1e-10;

/** An outline that leaves no ear this often crosses itself everywhere: it has no inside to keep clear of. */
const PATIENCE = 64;

/**
 * Triangles of a polygon in the plane, as corner numbers: always n − 2, every corner used. Takes n log n steps for
 * outlines that do not cross themselves.
 *
 * @param x, y  of the corners, counter-clockwise
 */
export function clipEars(x: Float64Array, y: Float64Array): [number, number, number][] {
  return new Clipper(x, y).run();
}

class Clipper {
  readonly #before: Int32Array;
  readonly #after: Int32Array;
  readonly #version: Uint32Array;
  readonly #isGone: Uint8Array;
  readonly #isConvex: Uint8Array;
  readonly #ears = new EarQueue();
  /** Corners that were not convex when `#leftThen` were left: only such can lie in an ear, if any does. */
  #blockers = new PointGrid([], [], []);
  #left: number;
  #leftThen = 0;
  #first = 0;
  #timesStuck = 0;

  constructor(
    private readonly x: Float64Array,
    private readonly y: Float64Array,
  ) {
    const n = x.length;
    this.#left = n;
    this.#before = Int32Array.from(x, (_, i) => (i + n - 1) % n);
    this.#after = Int32Array.from(x, (_, i) => (i + 1) % n);
    this.#version = new Uint32Array(n);
    this.#isGone = new Uint8Array(n);
    this.#isConvex = Uint8Array.from(x, (_, i) => Number(this.#turnsLeft(i)));
    this.#findBlockers();
    for (let i = 0; i < n; i++) this.#offer(i);
  }

  run(): [number, number, number][] {
    const triangles: [number, number, number][] = [];
    while (this.#left > 2) {
      const i = this.#best();
      triangles.push([this.#before[i]!, i, this.#after[i]!]);
      this.#cut(i);
    }
    return triangles;
  }

  #turn(a: number, b: number, c: number): number {
    const { x, y } = this;
    return (x[b]! - x[a]!) * (y[c]! - y[b]!) - (y[b]! - y[a]!) * (x[c]! - x[b]!);
  }

  #turnsLeft(i: number): boolean {
    const [a, c] = [this.#before[i]!, this.#after[i]!];
    const { x, y } = this;
    const size = Math.hypot(x[i]! - x[a]!, y[i]! - y[a]!) * Math.hypot(x[c]! - x[i]!, y[c]! - y[i]!);
    return this.#turn(a, i, c) > STRAIGHT * size;
  }

  #isBlocked(i: number): boolean {
    const [a, c] = [this.#before[i]!, this.#after[i]!];
    const { x, y } = this;
    const [xs, ys] = [
      [x[a]!, x[i]!, x[c]!],
      [y[a]!, y[i]!, y[c]!],
    ];
    return this.#blockers.any(Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys), (q) => {
      if (this.#isGone[q] || this.#isConvex[q]) return false;
      // A corner of the ear, or one that touches it there.
      for (let k = 0; k < 3; k++) if (x[q] === xs[k] && y[q] === ys[k]) return false;
      return this.#turn(a, i, q) >= 0 && this.#turn(i, c, q) >= 0 && this.#turn(c, a, q) >= 0;
    });
  }

  #findBlockers(): void {
    const found: number[] = [];
    for (const i of this.#remaining()) if (!this.#isConvex[i]) found.push(i);
    this.#blockers = new PointGrid(this.x, this.y, found);
    this.#leftThen = this.#left;
  }

  #cutLength(i: number): number {
    const [a, c] = [this.#before[i]!, this.#after[i]!];
    return Math.hypot(this.x[a]! - this.x[c]!, this.y[a]! - this.y[c]!);
  }

  #ear(i: number): Ear {
    return {
      isHollow: !this.#isConvex[i],
      cut: this.#cutLength(i),
      corner: i,
      version: this.#version[i]!,
    };
  }

  #offer(i: number): void {
    if (this.#timesStuck > PATIENCE || (this.#isConvex[i] && !this.#isBlocked(i)))
      this.#ears.push(this.#ear(i));
  }

  #best(): number {
    for (;;) {
      for (let ear = this.#ears.pop(); ear; ear = this.#ears.pop())
        if (!this.#isGone[ear.corner] && this.#version[ear.corner] === ear.version) return ear.corner;
      // What is left crosses itself or has no area: a corner is cut although something is in the way.
      if (++this.#timesStuck <= PATIENCE) return this.#leastBad();
      for (const i of this.#remaining()) this.#offer(i);
    }
  }

  #leastBad(): number {
    let best: Ear | undefined;
    for (const i of this.#remaining()) {
      const ear = this.#ear(i);
      if (!best || isBetter(ear, best)) best = ear;
    }
    return best!.corner;
  }

  *#remaining(): Generator<number> {
    while (this.#isGone[this.#first]) this.#first++;
    let i = this.#first;
    for (let count = this.#left; count > 0; count--) {
      yield i;
      i = this.#after[i]!;
    }
  }

  #cut(i: number): void {
    const sides = [this.#before[i]!, this.#after[i]!] as const;
    this.#after[sides[0]] = sides[1];
    this.#before[sides[1]] = sides[0];
    this.#isGone[i] = 1;
    this.#left--;
    let isSpoilt = false;
    for (const j of sides) {
      this.#version[j]!++;
      const wasConvex = this.#isConvex[j];
      this.#isConvex[j] = Number(this.#turnsLeft(j));
      isSpoilt ||= wasConvex === 1 && !this.#isConvex[j]; // only after a forced cut
    }
    // Short searches as the polygon shrinks.
    if (this.#timesStuck <= PATIENCE && (isSpoilt || this.#left < this.#leftThen / 2)) this.#findBlockers();
    for (const j of sides) this.#offer(j);
  }
}

interface Ear {
  /** Not convex: taken only when all else fails. */
  readonly isHollow: boolean;
  readonly cut: number;
  readonly corner: number;
  readonly version: number;
}

/** Shortest cut, then first corner. */
function isBetter(a: Ear, b: Ear): boolean {
  if (a.isHollow !== b.isHollow) return b.isHollow;
  return a.cut !== b.cut ? a.cut < b.cut : a.corner < b.corner;
}

/** A binary heap, the best ear on top. */
class EarQueue {
  readonly #heap: Ear[] = [];

  push(ear: Ear): void {
    const heap = this.#heap;
    let at = heap.length;
    for (heap.push(ear); at > 0; ) {
      const parent = (at - 1) >> 1;
      if (!isBetter(ear, heap[parent]!)) break;
      heap[at] = heap[parent]!;
      at = parent;
    }
    heap[at] = ear;
  }

  pop(): Ear | undefined {
    const heap = this.#heap;
    const top = heap[0];
    const last = heap.pop();
    if (!last || heap.length === 0) return top;
    let at = 0;
    for (;;) {
      let child = 2 * at + 1;
      if (child >= heap.length) break;
      if (child + 1 < heap.length && isBetter(heap[child + 1]!, heap[child]!)) child++;
      if (!isBetter(heap[child]!, last)) break;
      heap[at] = heap[child]!;
      at = child;
    }
    heap[at] = last;
    return top;
  }
}

/** Some points of the plane by squares that hold about one each. */
class PointGrid {
  readonly #left: number;
  readonly #low: number;
  readonly #side: number;
  readonly #columns: number;
  readonly #rows: number;
  readonly #start: Uint32Array;
  readonly #items: Uint32Array;

  constructor(x: ArrayLike<number>, y: ArrayLike<number>, some: readonly number[]) {
    let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const i of some) {
      [left, right] = [Math.min(left, x[i]!), Math.max(right, x[i]!)];
      [low, high] = [Math.min(low, y[i]!), Math.max(high, y[i]!)];
    }
    const [width, height] = some.length > 0 ? [right - left, high - low] : [0, 0];
    const side = Math.max(Math.sqrt((width * height) / some.length), Math.max(width, height) / some.length);
    this.#left = left;
    this.#low = low;
    this.#side = side > 0 ? side : 1;
    this.#columns = 1 + Math.floor(width / this.#side);
    this.#rows = 1 + Math.floor(height / this.#side);
    this.#start = new Uint32Array(this.#columns * this.#rows + 1);
    const cell = (i: number) => this.#row(y[i]!) * this.#columns + this.#column(x[i]!);
    for (const i of some) this.#start[cell(i) + 1]!++;
    for (let c = 1; c < this.#start.length; c++) this.#start[c]! += this.#start[c - 1]!;
    this.#items = new Uint32Array(some.length);
    const next = this.#start.slice();
    for (const i of some) this.#items[next[cell(i)]!++] = i;
  }

  /** Whether `test` holds for a point in or near a box. */
  any(left: number, low: number, right: number, high: number, test: (point: number) => boolean): boolean {
    if (this.#items.length === 0) return false;
    const [from, to] = [this.#column(left), this.#column(right)];
    for (let row = this.#row(low); row <= this.#row(high); row++) {
      const end = this.#start[row * this.#columns + to + 1]!;
      for (let k = this.#start[row * this.#columns + from]!; k < end; k++)
        if (test(this.#items[k]!)) return true;
    }
    return false;
  }

  #column(x: number): number {
    return Math.floor(Math.min(Math.max((x - this.#left) / this.#side, 0), this.#columns - 1));
  }

  #row(y: number): number {
    return Math.floor(Math.min(Math.max((y - this.#low) / this.#side, 0), this.#rows - 1));
  }
}
