/**
 * The vertices that lie across x = 0 from others, in model space: for each vertex the nearest to its
 * mirror image, if it is within a thousandth of the model's extent.
 */
export class Mirror {
  readonly #cells = new Map<string, number[]>();
  readonly #size: number;

  constructor(private readonly positions: Float64Array) {
    let extent = 0;
    for (const x of positions) if (Number.isFinite(x)) extent = Math.max(extent, Math.abs(x));
    this.#size = Math.max(extent * 2e-3, Number.MIN_VALUE);
    for (let v = 0; v < positions.length / 3; v++) {
      const key = this.#cell(positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!, 0, 0, 0);
      const cell = this.#cells.get(key);
      if (cell) cell.push(v);
      else this.#cells.set(key, [v]);
    }
  }

  /** The vertices and their partners, ascending. */
  both(vertices: Iterable<number>): Uint32Array {
    const out = new Set<number>();
    for (const v of vertices) {
      out.add(v);
      const partner = this.partner(v);
      if (partner !== undefined) out.add(partner);
    }
    return Uint32Array.from(out).sort();
  }

  partner(vertex: number): number | undefined {
    const x = -this.positions[3 * vertex]!;
    const y = this.positions[3 * vertex + 1]!;
    const z = this.positions[3 * vertex + 2]!;
    let best: number | undefined;
    let least = this.#size / 2;
    for (let i = -1; i <= 1; i++)
      for (let j = -1; j <= 1; j++)
        for (let k = -1; k <= 1; k++)
          for (const v of this.#cells.get(this.#cell(x, y, z, i, j, k)) ?? []) {
            const gap = Math.hypot(
              this.positions[3 * v]! - x,
              this.positions[3 * v + 1]! - y,
              this.positions[3 * v + 2]! - z,
            );
            if (gap < least) [best, least] = [v, gap];
          }
    return best;
  }

  #cell(x: number, y: number, z: number, i: number, j: number, k: number): string {
    const at = (value: number, step: number): number => Math.floor(value / this.#size) + step;
    return `${at(x, i)},${at(y, j)},${at(z, k)}`;
  }
}
