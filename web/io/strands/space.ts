import { faceCount, type Model, vertexCount, withPositions } from '../../core/model';
import type { Groom } from '../../core/strands';
import { isUsable } from '../normals';
import type { StrandWriteOptions } from './options';

// The one space of every file: centimetres, Y up. Head and strands pass through the same function.

type Place = (
  from: ArrayLike<number>,
  i: number,
  origin: readonly number[],
  to: Float32Array | Float64Array,
  j: number,
) => void;

/** Puts point i of `from`, moved by `origin`, at place j of `to`. A model whose up is z is laid on its back. */
export function toFileSpace(centimetresPerUnit: number, upAxis: 'y' | 'z' = 'y'): Place {
  const scale = centimetresPerUnit;
  return (from, i, origin, to, j) => {
    const x = scale * (from[3 * i]! + origin[0]!);
    const y = scale * (from[3 * i + 1]! + origin[1]!);
    const z = scale * (from[3 * i + 2]! + origin[2]!);
    to[3 * j] = x;
    to[3 * j + 1] = upAxis === 'z' ? z : y;
    to[3 * j + 2] = upAxis === 'z' ? -y : z;
  };
}

const HERE = [0, 0, 0];

/** The groom's head in the files' space, if it is to go along and has a face to show. */
export function headToWrite({ head }: Groom, options: StrandWriteOptions): Model | undefined {
  if (!head || options.withHead === false) return undefined;
  let usable = false;
  for (let f = 0; f < faceCount(head) && !usable; f++) usable = isUsable(head, f);
  if (!usable) return undefined;
  const positions = new Float64Array(head.positions.length);
  const place = toFileSpace(options.centimetresPerUnit, head.upAxis);
  for (let v = 0; v < vertexCount(head); v++) place(head.positions, v, HERE, positions, v);
  return { ...withPositions(head, positions), unitMetres: 0.01, upAxis: 'y' };
}

/** A head's faces as plain arrays. Vertices that are no point lie at the origin; no face names them. */
export interface HeadMesh {
  /** 3 per vertex. */
  readonly points: Float32Array;
  /** Corners per face. */
  readonly counts: Int32Array;
  /** Vertex per corner, counter-clockwise seen from outside. */
  readonly corners: Int32Array;
  /** 2 per corner. */
  readonly uvs?: Float32Array;
}

export function headMesh(head: Model): HeadMesh {
  const { faceOffsets, faceVertices, uvs, uvIndices } = head;
  const counts: number[] = [];
  const corners: number[] = [];
  const cornerUvs: number[] = [];
  for (let f = 0; f < faceCount(head); f++) {
    if (!isUsable(head, f)) continue;
    counts.push(faceOffsets[f + 1]! - faceOffsets[f]!);
    for (let c = faceOffsets[f]!; c < faceOffsets[f + 1]!; c++) {
      corners.push(faceVertices[c]!);
      const uv = uvIndices ? uvIndices[c]! : faceVertices[c]!;
      if (uvs) cornerUvs.push(uvs[2 * uv] ?? 0, uvs[2 * uv + 1] ?? 0);
    }
  }
  return {
    points: Float32Array.from(head.positions, (c) => (Number.isFinite(c) ? c : 0)),
    counts: Int32Array.from(counts),
    corners: Int32Array.from(corners),
    ...(uvs && { uvs: Float32Array.from(cornerUvs) }),
  };
}
