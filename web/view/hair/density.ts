// How much light reaches each place in and around the hair, coarsely: what a hair's breadth of shadow
// comes from is the opacity map's business.

import type { EvenStrands } from './resample';

type Triple = readonly [number, number, number];

/** A cube of cells with the strands' and the head's share of each: extinction, covered area per volume. */
export class DensityGrid {
  readonly cell: number;
  readonly low: Triple;
  readonly extinction: Float32Array;

  /** @param n  cells along each side of a cube around the box, with a rim of two empty ones */
  constructor(
    low: Triple,
    high: Triple,
    readonly n = 48,
  ) {
    const side = Math.max(1e-6, ...[0, 1, 2].map((k) => high[k]! - low[k]!));
    this.cell = side / (n - 4);
    const corner = (k: number): number => (low[k]! + high[k]!) / 2 - (this.cell * n) / 2;
    this.low = [corner(0), corner(1), corner(2)];
    this.extinction = new Float32Array(n * n * n);
  }

  get size(): number {
    return this.cell * this.n;
  }

  /**
   * A segment of length l and width w covers π/4·l·w from the mean direction.
   *
   * @param width  of a strand, drawn units
   * @param most   so many strands stand for all
   */
  addStrands(strands: EvenStrands, width: number, most = 20_000): void {
    const { points, perStrand } = strands;
    const used = Math.min(strands.count, most);
    const area = ((Math.PI / 4) * width * (strands.count / Math.max(1, used))) / this.cell ** 3;
    for (let s = 0; s < used; s++) {
      const first = 3 * s * perStrand;
      for (let p = first; p < first + 3 * (perStrand - 1); p += 3) {
        const dx = points[p + 3]! - points[p]!;
        const dy = points[p + 4]! - points[p + 1]!;
        const dz = points[p + 5]! - points[p + 2]!;
        const length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        this.#add(points[p]! + dx / 2, points[p + 1]! + dy / 2, points[p + 2]! + dz / 2, area * length);
      }
    }
  }

  /** A surface stops what `opacity` hairs' depth would stop. Large triangles are sampled at the cells' pitch. */
  addSurface(places: ArrayLike<number>, triangles: ArrayLike<number>, opacity: number): void {
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [3 * triangles[t]!, 3 * triangles[t + 1]!, 3 * triangles[t + 2]!];
      const u = [0, 1, 2].map((k) => places[b + k]! - places[a + k]!) as [number, number, number];
      const v = [0, 1, 2].map((k) => places[c + k]! - places[a + k]!) as [number, number, number];
      const cross = Math.hypot(
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
      );
      const pitch = Math.max(Math.hypot(...u), Math.hypot(...v)) / this.cell;
      const m = Math.min(64, Math.max(1, Math.ceil(1.5 * pitch)));
      const share = ((opacity * cross) / 2 / this.cell ** 3) * (1 / (m * m));
      // The middles of the m² similar triangles: m(m+1)/2 upright and m(m−1)/2 turned ones.
      for (let i = 0; i < m; i++) {
        for (let j = 0; j < m - i; j++) {
          for (const third of i + j < m - 1 ? [1 / 3, 2 / 3] : [1 / 3]) {
            const [s, r] = [(i + third) / m, (j + third) / m];
            const at = (k: 0 | 1 | 2): number => places[a + k]! + s * u[k] + r * v[k];
            this.#add(at(0), at(1), at(2), share);
          }
        }
      }
    }
  }

  /**
   * Optical depth between each cell's middle and the light far away in `direction`.
   *
   * Planes across the direction's main axis, from the light inwards: each cell continues the depth found
   * where its ray met the plane before.
   */
  depthTowards(direction: Triple, out = new Float32Array(this.extinction.length)): Float32Array {
    const { n, extinction, cell } = this;
    const axis = [0, 1, 2].reduce(
      (best, k) => (Math.abs(direction[k]!) > Math.abs(direction[best]!) ? k : best),
      0,
    );
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    const stride = [1, n, n * n];
    const [sa, su, sv] = [stride[axis]!, stride[u]!, stride[v]!];
    const main = Math.abs(direction[axis]!);
    const towards = direction[axis]! > 0 ? 1 : -1;
    const [du, dv] = [direction[u]! / main, direction[v]! / main];
    const half = (0.5 * cell * Math.hypot(...direction)) / main;
    const [iu, iv] = [Math.floor(du), Math.floor(dv)];
    const [fu, fv] = [du - iu, dv - iv];
    const [w00, w10, w01, w11] = [(1 - fu) * (1 - fv), fu * (1 - fv), (1 - fu) * fv, fu * fv];
    // Beyond the grid nothing stands in the way.
    const inside = (x: number, y: number): number => Number(x >= 0 && y >= 0 && x < n && y < n);
    for (let step = 0; step < n; step++) {
      const plane = towards > 0 ? n - 1 - step : step;
      for (let j = 0; j < n; j++) {
        const y = j + iv;
        const rowWithin = y >= 0 && y + 1 < n;
        for (let i = 0; i < n; i++) {
          const at = plane * sa + i * su + j * sv;
          if (step === 0) {
            out[at] = half * extinction[at]!;
            continue;
          }
          const x = i + iu;
          let [a, b, c, d] = [w00, w10, w01, w11];
          if (!rowWithin || x < 0 || x + 1 >= n) {
            a *= inside(x, y);
            b *= inside(x + 1, y);
            c *= inside(x, y + 1);
            d *= inside(x + 1, y + 1);
          }
          const p = (plane + towards) * sa + x * su + y * sv;
          let before = 0;
          let crossed = extinction[at]!;
          if (a > 0) {
            before += a * out[p]!;
            crossed += a * extinction[p]!;
          }
          if (b > 0) {
            before += b * out[p + su]!;
            crossed += b * extinction[p + su]!;
          }
          if (c > 0) {
            before += c * out[p + sv]!;
            crossed += c * extinction[p + sv]!;
          }
          if (d > 0) {
            before += d * out[p + su + sv]!;
            crossed += d * extinction[p + su + sv]!;
          }
          out[at] = before + half * crossed;
        }
      }
    }
    return out;
  }

  /** The share of an overcast sky that each cell sees, 0..1: brighter above than below, through the hair. */
  openness(): Float32Array {
    const seen = new Float32Array(this.extinction.length);
    const depth = new Float32Array(this.extinction.length);
    let total = 0;
    for (const direction of AROUND) {
      const light = skylight(direction[1] / Math.hypot(...direction));
      total += light;
      this.depthTowards(direction, depth);
      for (let i = 0; i < seen.length; i++) seen[i]! += light * Math.exp(-depth[i]!);
    }
    for (let i = 0; i < seen.length; i++) seen[i]! /= total;
    return seen;
  }

  /** Evens out the cells' grain: along every axis half of each cell goes to its neighbours. */
  smooth(): void {
    const { n, extinction } = this;
    const line = new Float32Array(n);
    for (const stride of [1, n, n * n]) {
      for (let start = 0; start < extinction.length; start++) {
        if (Math.floor(start / stride) % n !== 0) continue;
        for (let i = 0; i < n; i++) line[i] = extinction[start + i * stride]!;
        for (let i = 0; i < n; i++) {
          const [a, b] = [line[Math.max(0, i - 1)]!, line[Math.min(n - 1, i + 1)]!];
          extinction[start + i * stride] = (a + 2 * line[i]! + b) / 4;
        }
      }
    }
  }

  #add(x: number, y: number, z: number, amount: number): void {
    const { n, cell, low } = this;
    const i = Math.floor((x - low[0]) / cell);
    const j = Math.floor((y - low[1]) / cell);
    const k = Math.floor((z - low[2]) / cell);
    if (i < 0 || j < 0 || k < 0 || i >= n || j >= n || k >= n) return;
    this.extinction[i + n * (j + n * k)]! += amount;
  }
}

const ENDS = [-1, 1] as const;
/** Six axes and eight diagonals. */
const AROUND: readonly Triple[] = [
  ...ENDS.flatMap((s): Triple[] => [
    [s, 0, 0],
    [0, s, 0],
    [0, 0, s],
  ]),
  ...ENDS.flatMap((x) => ENDS.flatMap((y) => ENDS.map((z): Triple => [x, y, z]))),
];

/** The studio's walls: brighter towards the ceiling. */
function skylight(height: number): number {
  const t = Math.min(1, Math.max(0, (height + 0.6) / 1.4));
  return 0.13 + 0.37 * t * t * (3 - 2 * t);
}
