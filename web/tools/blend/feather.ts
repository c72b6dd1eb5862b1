/** Of a feather that nobody asked for, in radii of the part: what the kernel takes. */
const USUAL = 0.7;

/**
 * How far a part goes over into its surroundings when nobody says.
 * @param positions  of the skin that gives it, 3 per vertex
 */
export function usualFeather(
  positions: Float64Array,
  triangles: Uint32Array,
  vertices: Iterable<number>,
): number {
  const inside = new Set(vertices);
  let twice = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!] as const;
    if (!corners.every((v) => inside.has(v))) continue;
    const [a, b, c] = corners.map((v) => positions.subarray(3 * v, 3 * v + 3)) as [
      Float64Array,
      Float64Array,
      Float64Array,
    ];
    const u = [b[0]! - a[0]!, b[1]! - a[1]!, b[2]! - a[2]!] as const;
    const w = [c[0]! - a[0]!, c[1]! - a[1]!, c[2]! - a[2]!] as const;
    twice += Math.hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]);
  }
  return USUAL * Math.sqrt(twice / 2 / Math.PI);
}
