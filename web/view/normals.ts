// Smooth vertex normals: face normals weighted by the angle at the vertex, summed over welded vertices.

/** acos on [-1, 1] to 7e-5 (Abramowitz & Stegun, Handbook of Mathematical Functions, 4.4.45). */
function arcCosine(x: number): number {
  const a = Math.abs(x);
  const angle =
    Math.sqrt(Math.max(0, 1 - a)) * (1.5707288 + a * (-0.2121144 + a * (0.074261 - 0.0187293 * a)));
  return x < 0 ? Math.PI - angle : angle;
}

/** Angle weighting does not depend on how a polygon was cut into triangles, so quads shade evenly. */
export class VertexNormals {
  readonly #triangles: Uint32Array;
  readonly #slot: Uint32Array;
  readonly #sums: Float64Array;

  /**
   * @param triangles  3 source vertices each
   * @param welded     welded vertex per source vertex, −1 none
   */
  constructor(triangles: Uint32Array, welded: Int32Array) {
    let count = 0;
    for (const w of welded) if (w >= count) count = w + 1;
    this.#triangles = triangles;
    this.#slot = Uint32Array.from(welded, (w) => 3 * (w < 0 ? count : w));
    this.#sums = new Float64Array(3 * (count + 1));
  }

  /**
   * @param positions  3 per source vertex
   * @param out        3 per source vertex, unit length; (0, 1, 0) where no triangle with area meets
   */
  compute(positions: Float32Array, out: Float32Array): void {
    const sums = this.#sums.fill(0);
    const triangles = this.#triangles;
    const slot = this.#slot;
    for (let t = 0; t < triangles.length; t += 3) {
      const va = triangles[t]!;
      const vb = triangles[t + 1]!;
      const vc = triangles[t + 2]!;
      const a = 3 * va;
      const b = 3 * vb;
      const c = 3 * vc;
      const ax = positions[a]!;
      const ay = positions[a + 1]!;
      const az = positions[a + 2]!;
      const ux = positions[b]! - ax;
      const uy = positions[b + 1]! - ay;
      const uz = positions[b + 2]! - az;
      const vx = positions[c]! - ax;
      const vy = positions[c + 1]! - ay;
      const vz = positions[c + 2]! - az;
      const nx = uy * vz - uz * vy;
      const ny = uz * vx - ux * vz;
      const nz = ux * vy - uy * vx;
      const area = Math.sqrt(nx * nx + ny * ny + nz * nz);
      if (!(area > 0)) continue;
      const uu = ux * ux + uy * uy + uz * uz;
      const vv = vx * vx + vy * vy + vz * vz;
      const uv = ux * vx + uy * vy + uz * vz;
      const ww = uu + vv - 2 * uv;
      const atA = arcCosine(uv / Math.sqrt(uu * vv));
      const atB = arcCosine((uu - uv) / Math.sqrt(uu * Math.max(ww, 1e-300)));
      add(sums, slot[va]!, nx, ny, nz, atA / area);
      add(sums, slot[vb]!, nx, ny, nz, atB / area);
      add(sums, slot[vc]!, nx, ny, nz, Math.max(0, Math.PI - atA - atB) / area);
    }
    for (let v = 0; v < slot.length; v++) {
      const s = slot[v]!;
      const x = sums[s]!;
      const y = sums[s + 1]!;
      const z = sums[s + 2]!;
      const length = Math.sqrt(x * x + y * y + z * z);
      const k = length > 0 ? 1 / length : 0;
      out[3 * v] = x * k;
      out[3 * v + 1] = length > 0 ? y * k : 1;
      out[3 * v + 2] = z * k;
    }
  }
}

function add(sums: Float64Array, s: number, x: number, y: number, z: number, weight: number): void {
  sums[s]! += x * weight;
  sums[s + 1]! += y * weight;
  sums[s + 2]! += z * weight;
}

/**
 * Whether a surface that encloses space has its faces turned inwards. A sheet, or one that hardly closes,
 * counts as it was written.
 */
export function facesInwards(positions: Float32Array, triangles: Uint32Array): boolean {
  let volume = 0;
  let area = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t]!;
    const b = 3 * triangles[t + 1]!;
    const c = 3 * triangles[t + 2]!;
    const [ax, ay, az] = [positions[a]!, positions[a + 1]!, positions[a + 2]!];
    const [bx, by, bz] = [positions[b]!, positions[b + 1]!, positions[b + 2]!];
    const [cx, cy, cz] = [positions[c]!, positions[c + 1]!, positions[c + 2]!];
    const nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay);
    const ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az);
    const nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    area += Math.sqrt(nx * nx + ny * ny + nz * nz) / 2;
    volume += (ax * nx + ay * ny + az * nz) / 6;
  }
  return volume < -1e-3 * area ** 1.5;
}

/**
 * Whether the surface has no border and one orientation: every directed edge has its reverse. Compared by a
 * sum of hashes, so a chance agreement of an open surface is thinkable; it would be drawn without its inside.
 */
export function isClosed(triangles: Uint32Array, welded: Int32Array): boolean {
  let balance = 0;
  for (let i = 0; i < triangles.length; i++) {
    const a = welded[triangles[i]!]!;
    const b = welded[triangles[i % 3 === 2 ? i - 2 : i + 1]!]!;
    balance = (balance + edgeHash(a, b) - edgeHash(b, a)) | 0;
  }
  return triangles.length > 0 && balance === 0;
}

function edgeHash(a: number, b: number): number {
  let h = Math.imul(a + 1, 0x9e3779b1) ^ Math.imul(b + 0x7f4a7c15, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 15), 0xc2b2ae35);
  return h ^ (h >>> 13);
}
