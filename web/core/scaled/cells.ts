// Cellular noise (Worley 1996): space falls into cells about seeds, one scattered in each cube of a grid. Sums, products and
// roots only: the same bytes in every browser.

/** What the nearest seeds are from a place. */
export interface Nearest {
  /** Distance from the nearest, in edges of the grid's cubes. */
  first: number;
  /** From the second nearest. */
  second: number;
}

/**
 * Seeds about a box.
 *
 * @param low,high  its corners
 * @param size  edge of the grid's cubes: about how large the cells are
 * @returns what finds the nearest seeds to a place in the box; it answers with the same object every time
 */
export function cells(
  low: readonly number[],
  high: readonly number[],
  size: number,
): (x: number, y: number, z: number) => Nearest {
  // A cube more all around: the nearest seed may lie outside the box.
  const counts = low.map((l, k) => Math.floor((high[k]! - l) / size) + 3);
  const [nx, ny, nz] = counts as [number, number, number];
  const seeds = new Float64Array(3 * nx * ny * nz);
  for (let i = 0; i < seeds.length; i++) seeds[i] = scattered(i);
  const nearest: Nearest = { first: 0, second: 0 };
  return (x, y, z) => {
    const px = (x - low[0]!) / size + 1;
    const py = (y - low[1]!) / size + 1;
    const pz = (z - low[2]!) / size + 1;
    const ix = Math.floor(px);
    const iy = Math.floor(py);
    const iz = Math.floor(pz);
    let first = Number.POSITIVE_INFINITY;
    let second = Number.POSITIVE_INFINITY;
    for (let k = Math.max(0, iz - 1); k <= Math.min(nz - 1, iz + 1); k++)
      for (let j = Math.max(0, iy - 1); j <= Math.min(ny - 1, iy + 1); j++)
        for (let i = Math.max(0, ix - 1); i <= Math.min(nx - 1, ix + 1); i++) {
          const at = 3 * ((k * ny + j) * nx + i);
          const dx = i + seeds[at]! - px;
          const dy = j + seeds[at + 1]! - py;
          const dz = k + seeds[at + 2]! - pz;
          const squared = dx * dx + dy * dy + dz * dz;
          if (squared < first) {
            second = first;
            first = squared;
          } else if (squared < second) second = squared;
        }
    nearest.first = Math.sqrt(first);
    nearest.second = Math.sqrt(second);
    return nearest;
  };
}

/** A number in [0, 1) that looks drawn by lot (the mixing of MurmurHash3). */
function scattered(n: number): number {
  let h = Math.imul(n ^ (n >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}
