// Models whose triangles say little of a surface: points with one drawn through them, and triangles that know nothing of
// one another.

/** Welded vertices per triangle: a surface has half as many as triangles, a strip as many, lone quads twice. */
const LOOSE = 1.5;
/** Fewer triangles are a sheet or two, which have a back. */
const FEW = 64;
/** Of the mean gap between points: they touch no other, and hide what is behind. */
const FILLED = 0.85;

/** Whether most triangles share no corners: a soup, of which nobody can say which side is the inside. */
export function isSoup(triangles: Uint32Array, welded: Int32Array): boolean {
  const count = triangles.length / 3;
  if (count < FEW) return false;
  const used = new Uint8Array(welded.length);
  let corners = 0;
  for (const v of triangles) {
    const w = welded[v]!;
    if (w < 0 || used[w]) continue;
    used[w] = 1;
    corners++;
  }
  return corners > LOOSE * count;
}

/** Diameter of the dots that points are drawn as, in the unit of the places: by the area that each has of the surface through them. */
export function dotSize(places: Float32Array, triangles: Uint32Array): number {
  let area = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t]!, 3 * triangles[t + 1]!, 3 * triangles[t + 2]!];
    const [ux, uy, uz] = [0, 1, 2].map((k) => places[b + k]! - places[a + k]!) as [number, number, number];
    const [vx, vy, vz] = [0, 1, 2].map((k) => places[c + k]! - places[a + k]!) as [number, number, number];
    area += Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
  }
  return FILLED * Math.sqrt((3 * area) / Math.max(1, places.length));
}
