import { faceCount, type Model, vertexCount } from '../../core/model';
import type { Groom } from '../../core/strands';
import { ByteWriter } from '../byte-writer';
import { toSrgb } from '../srgb';
import { type Curves, curveCount, curvesToWrite, pointCount } from './curves';
import type { StrandWriteOptions } from './options';
import { type HeadMesh, headMesh, headToWrite } from './space';

/**
 * Binary PLY: vertices of the head, then of the strands, root first; for each vertex its colour, its strand (−1 on
 * the head) and the strand's diameter there; the head's faces; an edge per segment.
 */
export function writeStrandPly(groom: Groom, options: StrandWriteOptions): Uint8Array {
  const curves = curvesToWrite(groom, options);
  const model = headToWrite(groom, options);
  const head = model && headMesh(model);
  const headVertices = model ? vertexCount(model) : 0;
  const segments = pointCount(curves) - curveCount(curves);
  const out = new ByteWriter(1024 + 23 * (headVertices + pointCount(curves)) + 8 * segments);
  out.text('ply\nformat binary_little_endian 1.0\ncomment unit: 0.01 m\ncomment up: y\n');
  out.text(`element vertex ${headVertices + pointCount(curves)}\n`);
  for (const axis of ['x', 'y', 'z']) out.text(`property float ${axis}\n`);
  for (const level of ['red', 'green', 'blue']) out.text(`property uchar ${level}\n`);
  out.text('property int strand\nproperty float width\n');
  if (head)
    out.text(`element face ${head.counts.length}\nproperty list ${listType(model)} int vertex_indices\n`);
  out.text(`element edge ${segments}\nproperty int vertex1\nproperty int vertex2\nend_header\n`);
  if (model && head) writeHeadVertices(out, model, head);
  writeStrandVertices(out, curves);
  if (model && head) writeHeadFaces(out, head, listType(model));
  for (let i = 0; i < curveCount(curves); i++)
    for (let p = curves.offsets[i]! + 1; p < curves.offsets[i + 1]!; p++) {
      out.u32(headVertices + p - 1);
      out.u32(headVertices + p);
    }
  return out.finish();
}

function writeHeadVertices(out: ByteWriter, { colors }: Model, { points }: HeadMesh): void {
  for (let v = 0; v < points.length / 3; v++) {
    for (let k = 0; k < 3; k++) out.f32(points[3 * v + k]!);
    for (let k = 0; k < 3; k++) out.byte(colors ? colors[4 * v + k]! : 255);
    out.u32(-1);
    out.f32(0);
  }
}

function writeStrandVertices(out: ByteWriter, { offsets, points, widths, colors, ids }: Curves): void {
  for (let i = 0; i < ids.length; i++) {
    const rgb = [0, 1, 2].map((k) => Math.round(toSrgb(colors[3 * i + k]!)));
    for (let p = offsets[i]!; p < offsets[i + 1]!; p++) {
      for (let k = 0; k < 3; k++) out.f32(points[3 * p + k]!);
      for (const level of rgb) out.byte(level);
      out.u32(ids[i]!);
      out.f32(widths[p]!);
    }
  }
}

function writeHeadFaces(out: ByteWriter, { counts, corners }: HeadMesh, type: 'uchar' | 'int'): void {
  let corner = 0;
  for (const count of counts) {
    if (type === 'uchar') out.byte(count);
    else out.u32(count);
    for (let k = 0; k < count; k++) out.u32(corners[corner++]!);
  }
}

function listType(model: Model | undefined): 'uchar' | 'int' {
  for (let f = 0; model && f < faceCount(model); f++)
    if (model.faceOffsets[f + 1]! - model.faceOffsets[f]! > 255) return 'int';
  return 'uchar';
}
