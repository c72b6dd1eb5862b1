// Surfaces to try merge tools on: sheets of quads split in two, one vertex a lattice point.

export interface Sheet {
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
  readonly welded: Int32Array;
}

/** A sheet of n × m vertices at the places (x, y); cells for which `hole` holds are left out. */
export function sheet(n: number, m: number, hole: (x: number, y: number) => boolean = () => false): Sheet {
  const positions = new Float64Array(3 * n * m);
  const triangles: number[] = [];
  for (let y = 0; y < m; y++)
    for (let x = 0; x < n; x++) {
      positions.set([x, y, 0], 3 * (y * n + x));
      if (x + 1 === n || y + 1 === m || hole(x, y)) continue;
      const v = y * n + x;
      triangles.push(v, v + 1, v + n + 1, v, v + n + 1, v + n);
    }
  const welded = Int32Array.from({ length: n * m }, (_, i) => i);
  return { positions, triangles: Uint32Array.from(triangles), welded };
}

/** The same with every triangle's corners as vertices of their own, as STL files have them. */
export function soup({ positions, triangles }: Sheet): Sheet {
  const corners = [...triangles];
  return {
    positions: Float64Array.from(corners.flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)])),
    triangles: Uint32Array.from(corners.keys()),
    welded: Int32Array.from(corners),
  };
}
