// Loop subdivision (Loop 1987) with Warren's weights, which need no trigonometry: the same bytes in every browser.

/** A surface of triangles. */
export interface Surface {
  /** 3 per vertex. */
  readonly positions: Float64Array;
  /** 3 vertices per triangle. */
  readonly corners: Uint32Array;
}

/**
 * Each triangle cut into four, and the surface smoothed. Vertices keep their numbers, those on edges follow in the order
 * of the triangles. An edge of one triangle, or of more than two, is a crease of its own (boundary rule).
 *
 * Time and memory: linear in the triangles.
 */
export function loopSubdivided({ positions, corners }: Surface): Surface {
  const count = positions.length / 3;
  const edges = edgesOf(corners, count);
  const finer = new Float64Array(3 * (count + edges.count));
  moveOld(finer, positions, edges);
  placeNew(finer, positions, edges);
  return { positions: finer, corners: cutInFour(corners, edges.ofCorner, count) };
}

interface Edges {
  readonly count: number;
  /** 2 vertices each. */
  readonly ends: Uint32Array;
  /** 2 each: vertices opposite to it, in the first two of its triangles. */
  readonly opposite: Uint32Array;
  /** Triangles of each. */
  readonly faces: Uint8Array;
  /** Of each corner, the edge from it to the next one. */
  readonly ofCorner: Uint32Array;
}

const NONE = 0xffffffff;
/** Counted no further: an edge of three triangles and one of thirty are the same. */
const MANY = 3;

function edgesOf(corners: Uint32Array, vertices: number): Edges {
  const ends = new Uint32Array(2 * corners.length);
  const opposite = new Uint32Array(2 * corners.length);
  const faces = new Uint8Array(corners.length);
  const ofCorner = new Uint32Array(corners.length);
  // The edges that start at a vertex, the smaller of their ends, as a chain.
  const first = new Uint32Array(vertices).fill(NONE);
  const next = new Uint32Array(corners.length);
  let count = 0;
  for (let c = 0; c < corners.length; c++) {
    const face = c - (c % 3);
    const a = corners[c]!;
    const b = corners[face + ((c + 1) % 3)]!;
    const low = Math.min(a, b);
    const high = Math.max(a, b);
    let edge = first[low]!;
    while (edge !== NONE && ends[2 * edge + 1] !== high) edge = next[edge]!;
    if (edge === NONE) {
      edge = count++;
      ends[2 * edge] = low;
      ends[2 * edge + 1] = high;
      next[edge] = first[low]!;
      first[low] = edge;
    }
    if (faces[edge]! < 2) opposite[2 * edge + faces[edge]!] = corners[face + ((c + 2) % 3)]!;
    faces[edge] = Math.min(MANY, faces[edge]! + 1);
    ofCorner[c] = edge;
  }
  return { count, ends, opposite, faces, ofCorner };
}

/** On an edge: 3/8 of its ends, 1/8 of the vertices opposite; half and half on a crease. */
function placeNew(finer: Float64Array, positions: Float64Array, { count, ends, opposite, faces }: Edges) {
  for (let e = 0; e < count; e++) {
    const a = 3 * ends[2 * e]!;
    const b = 3 * ends[2 * e + 1]!;
    const c = 3 * opposite[2 * e]!;
    const d = 3 * opposite[2 * e + 1]!;
    const isCrease = faces[e] !== 2;
    for (let k = 0; k < 3; k++) {
      const along = positions[a + k]! + positions[b + k]!;
      finer[positions.length + 3 * e + k] = isCrease
        ? 0.5 * along
        : 0.375 * along + 0.125 * (positions[c + k]! + positions[d + k]!);
    }
  }
}

/** Towards the mean of the neighbours; on a crease, of the two neighbours along it. */
function moveOld(finer: Float64Array, positions: Float64Array, { count, ends, faces }: Edges): void {
  const vertices = positions.length / 3;
  const [valence, creases] = [new Uint32Array(vertices), new Uint32Array(vertices)];
  for (let e = 0; e < count; e++)
    for (let side = 0; side < 2; side++) {
      const v = ends[2 * e + side]!;
      valence[v]!++;
      if (faces[e] !== 2) creases[v]!++;
    }
  for (let e = 0; e < count; e++)
    for (let side = 0; side < 2; side++) {
      const v = ends[2 * e + side]!;
      const w = ends[2 * e + 1 - side]!;
      // Where creases meet or end, nothing pulls.
      if (creases[v]! > 0 && (faces[e] === 2 || creases[v] !== 2)) continue;
      for (let k = 0; k < 3; k++) finer[3 * v + k]! += positions[3 * w + k]!;
    }
  for (let v = 0; v < vertices; v++) {
    const n = creases[v] === 0 ? valence[v]! : creases[v] === 2 ? 2 : 0;
    const weight = n === 0 ? 0 : creases[v]! > 0 ? 0.125 : n === 3 ? 0.1875 : 0.375 / n;
    for (let k = 0; k < 3; k++)
      finer[3 * v + k] = (1 - n * weight) * positions[3 * v + k]! + weight * finer[3 * v + k]!;
  }
}

function cutInFour(corners: Uint32Array, ofCorner: Uint32Array, vertices: number): Uint32Array {
  const finer = new Uint32Array(4 * corners.length);
  for (let c = 0; c < corners.length; c += 3) {
    const pq = vertices + ofCorner[c]!;
    const qr = vertices + ofCorner[c + 1]!;
    const rp = vertices + ofCorner[c + 2]!;
    finer.set([corners[c]!, pq, rp, corners[c + 1]!, qr, pq, corners[c + 2]!, rp, qr, pq, qr, rp], 4 * c);
  }
  return finer;
}
