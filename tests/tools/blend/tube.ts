// An upright tube of rings, closed by a fan at either end.

/** @param radius  of a height from 0 to 1 */
export function tube(
  radius: (share: number) => number,
  { rings = 40, around = 24, height = 1, shift = [0, 0, 0] as readonly number[] } = {},
): { readonly positions: Float64Array; readonly triangles: Uint32Array } {
  const positions: number[] = [];
  for (let i = 0; i <= rings; i++)
    for (let j = 0; j < around; j++) {
      const angle = (2 * Math.PI * j) / around;
      const r = radius(i / rings);
      positions.push(
        r * Math.cos(angle) + shift[0]!,
        (height * i) / rings + shift[1]!,
        -r * Math.sin(angle) + shift[2]!,
      );
    }
  const triangles: number[] = [];
  for (let i = 0; i < rings; i++)
    for (let j = 0; j < around; j++) {
      const [a, b] = [i * around + j, i * around + ((j + 1) % around)];
      triangles.push(a, b, b + around, a, b + around, a + around);
    }
  const caps = positions.length / 3;
  positions.push(shift[0]!, shift[1]!, shift[2]!, shift[0]!, height + shift[1]!, shift[2]!);
  for (let j = 0; j < around; j++) {
    const next = (j + 1) % around;
    triangles.push(caps, next, j, caps + 1, rings * around + j, rings * around + next);
  }
  return { positions: Float64Array.from(positions), triangles: Uint32Array.from(triangles) };
}
