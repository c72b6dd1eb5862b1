import type { Model } from '../core/model';

/**
 * Unit normals, 3 per vertex: the mean of the adjacent faces' normals, weighted by area; (0, 0, 0) for vertices
 * without a usable face.
 */
export function vertexNormals(
  model: Pick<Model, 'positions' | 'faceOffsets' | 'faceVertices'>,
): Float64Array {
  const { positions: p, faceOffsets, faceVertices } = model;
  const count = p.length / 3;
  const normals = new Float64Array(p.length);
  for (let f = 0; f < faceOffsets.length - 1; f++) {
    const start = faceOffsets[f]!;
    const end = faceOffsets[f + 1]!;
    const n = faceNormal(p, faceVertices, start, end);
    if (!Number.isFinite(n[0] + n[1] + n[2])) continue;
    for (let i = start; i < end; i++) {
      const v = faceVertices[i]!;
      if (v < count) for (let k = 0; k < 3; k++) normals[3 * v + k]! += n[k]!;
    }
  }
  for (let v = 0; v < count; v++) {
    const length = Math.hypot(normals[3 * v]!, normals[3 * v + 1]!, normals[3 * v + 2]!);
    if (length > 0) for (let k = 0; k < 3; k++) normals[3 * v + k]! /= length;
  }
  return normals;
}

/** Newell's normal of corners [start, end): twice the area long; NaN where a corner is missing or not finite. */
export function faceNormal(
  p: Float64Array,
  corners: Uint32Array,
  start: number,
  end: number,
): [number, number, number] {
  const n: [number, number, number] = [0, 0, 0];
  const o = 3 * corners[start]!;
  // Seen from the first corner, so that a far-off model loses no digits.
  for (let i = start + 1; i + 1 < end; i++) {
    const a = 3 * corners[i]!;
    const b = 3 * corners[i + 1]!;
    const [ax, ay, az] = [p[a]! - p[o]!, p[a + 1]! - p[o + 1]!, p[a + 2]! - p[o + 2]!];
    const [bx, by, bz] = [p[b]! - p[o]!, p[b + 1]! - p[o + 1]!, p[b + 2]! - p[o + 2]!];
    n[0] += ay * bz - az * by;
    n[1] += az * bx - ax * bz;
    n[2] += ax * by - ay * bx;
  }
  return n;
}

/** Whether every corner of face f names a vertex with finite coordinates. */
export function isUsable({ positions, faceOffsets, faceVertices }: Model, f: number): boolean {
  for (let i = faceOffsets[f]!; i < faceOffsets[f + 1]!; i++) {
    const v = 3 * faceVertices[i]!;
    if (!Number.isFinite(positions[v]! + positions[v + 1]! + positions[v + 2]!)) return false;
  }
  return true;
}
