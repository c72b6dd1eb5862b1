// How far cloth lies from a body: less than 0 inside. Near the body by the plane of the nearest vertex, farther out by the distance
// to it. Pure.

/**
 * @param cloth      3 per vertex
 * @param body       3 per vertex
 * @param triangles  3 vertices of the body each
 * @returns one number per vertex of the cloth, in units of both
 */
export function clearances(cloth: Float64Array, body: Float64Array, triangles: Uint32Array): Float32Array {
  const grid = new VertexGrid(body, 2 * meanEdge(body, triangles));
  const normals = normalsOf(body, triangles);
  const out = new Float32Array(cloth.length / 3);
  for (let i = 0; i < out.length; i++) {
    const [x, y, z] = [cloth[3 * i]!, cloth[3 * i + 1]!, cloth[3 * i + 2]!];
    const v = 3 * grid.nearest(x, y, z);
    const d = [x - body[v]!, y - body[v + 1]!, z - body[v + 2]!] as const;
    const off = d[0] * normals[v]! + d[1] * normals[v + 1]! + d[2] * normals[v + 2]!;
    const size = Math.max(Math.abs(off), Math.hypot(...d) - grid.cell);
    out[i] = off < 0 ? -size : size;
  }
  return out;
}

/** Vertices by the cells of a grid, to find the nearest one. */
class VertexGrid {
  readonly #cells = new Map<string, number[]>();

  constructor(
    private readonly positions: Float64Array,
    readonly cell: number,
  ) {
    for (let v = 0; v < positions.length / 3; v++) {
      const key = this.#key(this.#at(3 * v));
      const held = this.#cells.get(key);
      if (held) held.push(v);
      else this.#cells.set(key, [v]);
    }
  }

  nearest(x: number, y: number, z: number): number {
    const middle = [x, y, z].map((c) => Math.floor(c / this.cell)) as [number, number, number];
    let [best, least] = [0, Infinity];
    // Rings of cells, until the next one must be farther away than what was found.
    for (let ring = 0; ring <= FARTHEST && (ring - 1) * this.cell <= least; ring++)
      for (const place of shell(middle, ring))
        for (const v of this.#cells.get(this.#key(place)) ?? []) {
          const p = this.positions;
          const far = Math.hypot(x - p[3 * v]!, y - p[3 * v + 1]!, z - p[3 * v + 2]!);
          if (far < least) [best, least] = [v, far];
        }
    if (least < Infinity) return best;
    for (let v = 0; v < this.positions.length / 3; v++) {
      const p = this.positions;
      const far = Math.hypot(x - p[3 * v]!, y - p[3 * v + 1]!, z - p[3 * v + 2]!);
      if (far < least) [best, least] = [v, far];
    }
    return best;
  }

  #at(i: number): [number, number, number] {
    return [0, 1, 2].map((k) => Math.floor(this.positions[i + k]! / this.cell)) as [number, number, number];
  }

  #key([i, j, k]: readonly [number, number, number]): string {
    return `${i} ${j} ${k}`;
  }
}

/** Rings of cells that are looked through before all vertices are. */
const FARTHEST = 24;

/** The cells at so many steps from one, by their largest step along an axis. */
function* shell(
  [a, b, c]: readonly [number, number, number],
  ring: number,
): Iterable<[number, number, number]> {
  for (let i = -ring; i <= ring; i++)
    for (let j = -ring; j <= ring; j++) {
      const isSide = Math.abs(i) === ring || Math.abs(j) === ring;
      const step = isSide || ring === 0 ? 1 : 2 * ring;
      for (let k = -ring; k <= ring; k += step) yield [a + i, b + j, c + k];
    }
}

function meanEdge(positions: Float64Array, triangles: Uint32Array): number {
  let sum = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b] = [3 * triangles[t]!, 3 * triangles[t + 1]!];
    sum += Math.hypot(...[0, 1, 2].map((k) => positions[a + k]! - positions[b + k]!));
  }
  return triangles.length > 0 ? sum / (triangles.length / 3) || 1 : 1;
}

/** Of unit length, weighted by area. */
function normalsOf(positions: Float64Array, triangles: Uint32Array): Float64Array {
  const out = new Float64Array(positions.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t]!, 3 * triangles[t + 1]!, 3 * triangles[t + 2]!];
    const u = [0, 1, 2].map((k) => positions[b + k]! - positions[a + k]!);
    const v = [0, 1, 2].map((k) => positions[c + k]! - positions[a + k]!);
    const normal = [
      u[1]! * v[2]! - u[2]! * v[1]!,
      u[2]! * v[0]! - u[0]! * v[2]!,
      u[0]! * v[1]! - u[1]! * v[0]!,
    ];
    for (const corner of [a, b, c])
      for (let k = 0; k < 3; k++) out[corner + k] = out[corner + k]! + normal[k]!;
  }
  for (let v = 0; v < out.length; v += 3) {
    const size = Math.hypot(out[v]!, out[v + 1]!, out[v + 2]!) || 1;
    for (let k = 0; k < 3; k++) out[v + k] = out[v + k]! / size;
  }
  return out;
}
