import type { Model } from '../core/model';
import { clipEars } from './ear-clipping';
import { faceNormal, isUsable } from './normals';

/**
 * Faces as triangles, for formats that hold nothing else: 3 vertex indices each, in face order, and the face of
 * each. Quads are cut along the diagonal that keeps both halves facing one way (the shorter if both do), larger
 * polygons by ear clipping in their mean plane, shortest cuts first. Faces with a missing or non-finite corner give none.
 */
export function triangulate(model: Model): { triangles: Uint32Array; faces: Uint32Array } {
  const { faceOffsets, faceVertices } = model;
  const faceTotal = faceOffsets.length - 1;
  const most = Math.max(0, faceVertices.length - 2 * faceTotal);
  const corners = new Uint32Array(3 * most);
  const faces = new Uint32Array(most);
  let count = 0;
  const put = (face: number, a: number, b: number, c: number) => {
    corners.set([a, b, c], 3 * count);
    faces[count++] = face;
  };
  for (let f = 0; f < faceTotal; f++) {
    if (!isUsable(model, f)) continue;
    const start = faceOffsets[f]!;
    const size = faceOffsets[f + 1]! - start;
    if (size === 3) put(f, start, start + 1, start + 2);
    else if (size === 4) {
      const q = start + betterDiagonal(model, start);
      const at = (k: number) => start + ((q - start + k) % 4);
      put(f, at(0), at(1), at(2));
      put(f, at(0), at(2), at(3));
    } else if (size > 4) for (const [a, b, c] of cutPolygon(model, start, start + size)) put(f, a, b, c);
  }
  return { triangles: corners.slice(0, 3 * count), faces: faces.slice(0, count) };
}

/** 0 to cut a quad from its first to its third corner, 1 for the other diagonal. */
function betterDiagonal({ positions: p, faceVertices: v }: Model, s: number): 0 | 1 {
  const facing = (a: number, b: number, c: number, d: number): number => {
    const m = faceNormal(p, Uint32Array.of(v[a]!, v[b]!, v[c]!), 0, 3);
    const n = faceNormal(p, Uint32Array.of(v[a]!, v[c]!, v[d]!), 0, 3);
    return m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
  };
  const first = facing(s, s + 1, s + 2, s + 3) > 0;
  const second = facing(s + 1, s + 2, s + 3, s) > 0;
  if (first !== second) return first ? 0 : 1;
  const length = (a: number, b: number) => {
    const [i, j] = [3 * v[a]!, 3 * v[b]!];
    return Math.hypot(p[i]! - p[j]!, p[i + 1]! - p[j + 1]!, p[i + 2]! - p[j + 2]!);
  };
  return length(s, s + 2) <= length(s + 1, s + 3) ? 0 : 1;
}

/** Triangles of the polygon of corners [start, end), as corner numbers: always end − start − 2. */
function cutPolygon(
  { positions: p, faceVertices: v }: Model,
  start: number,
  end: number,
): [number, number, number][] {
  const n = faceNormal(p, v, start, end);
  // Without the coordinate along which the normal is longest; the polygon then turns counter-clockwise.
  const drop = n.reduce((best, value, k) => (Math.abs(value) > Math.abs(n[best]!) ? k : best), 0);
  const [i, j] = n[drop]! < 0 ? [(drop + 2) % 3, (drop + 1) % 3] : [(drop + 1) % 3, (drop + 2) % 3];
  const o = 3 * v[start]!;
  const corners = v.subarray(start, end);
  const x = Float64Array.from(corners, (corner) => p[3 * corner + i]! - p[o + i]!);
  const y = Float64Array.from(corners, (corner) => p[3 * corner + j]! - p[o + j]!);
  return clipEars(x, y).map(([a, b, c]) => [start + a, start + b, start + c]);
}
