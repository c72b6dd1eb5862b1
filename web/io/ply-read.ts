import { LissomError } from '../core/errors';
import type { Model } from '../core/model';
import { Budget } from './budget';
import { Notes } from './notes';
import { namesVertices, PlyFaces } from './ply-faces';
import { PLY_BYTES, type PlyElement, type PlyHeader, readPlyHeader } from './ply-header';
import { type PlyValues, plyValues } from './ply-values';
import { type PlyColumn, readVertices } from './ply-vertices';
import { checkAnnounced, type ReadResult } from './reading';
import { fromUnitComments } from './units-comment';

/** What a PLY export puts back beside the model proper. */
export interface PlyExtra {
  readonly comments: readonly string[];
  /** Scalar properties without a meaning here (quality, confidence …), a row per vertex or face. */
  readonly vertexColumns: readonly PlyColumn[];
  readonly faceColumns: readonly PlyColumn[];
  /** Normals came along, so normals go out: computed anew. */
  readonly normals: boolean;
}

/**
 * Stanford PLY, ascii or binary of either byte order: polygons or triangle strips, colours, texture coordinates
 * per vertex or per corner, vertex sets (`property uchar scalp` of zeros and ones).
 *
 * @throws LissomError `file-truncated`, `file-damaged`, `count-too-large`, `file-not-a-mesh`, `file-too-large`,
 *                     `file-unfolds-too-far`
 */
export function readPly(bytes: Uint8Array, name: string): ReadResult {
  const budget = new Budget('mesh', name, bytes.length);
  const header = readPlyHeader(bytes, name);
  checkCounts(header, bytes.length, name);
  const values = plyValues(bytes, header, name);
  const notes = new Notes();
  const faces = new PlyFaces(name, notes, budget);
  let vertices: ReturnType<typeof readVertices> | undefined;
  for (const element of header.elements) {
    if (element.name === 'vertex' && !vertices) {
      // Each value as a double; what is no coordinate is kept in a column of its own.
      budget.take(8 * element.count * element.properties.length);
      vertices = readVertices(values, element, name);
    } else if (element.name === 'face' && namesVertices(element)) faces.read(values, element);
    else if (element.name === 'tristrips' && namesVertices(element)) faces.readStrips(values, element);
    else {
      skip(values, element);
      if (element.count > 0)
        notes.add('element-ignored', `${name} holds “${element.name}” data, which was passed over.`);
    }
  }
  if (!vertices) {
    const message = `${name} announces no vertices with x, y and z, so it holds no model. Open another file.`;
    throw new LissomError('file-not-a-mesh', message);
  }
  if (faces.count === 0)
    notes.add('no-faces', `${name} holds points but no faces: a surface is drawn through them to work on.`);
  const { units, others } = fromUnitComments(header.comments);
  const { columns, normals, ...perVertex } = vertices;
  const { faceColumns, ...perFace } = faces.finish();
  const extra: PlyExtra = { comments: others, vertexColumns: columns, faceColumns, normals };
  const model: Model = {
    name,
    ...perVertex,
    ...perFace,
    ...units,
    origin: { format: 'ply', extra },
  };
  return { model, notes: notes.list() };
}

const PLURALS = new Map([
  ['vertex', 'vertices'],
  ['face', 'faces'],
]);

/** Everything announced must fit in the file: its least size is known before a row is read. */
function checkCounts(header: PlyHeader, length: number, name: string): void {
  const present = length - header.dataStart;
  let needed = 0;
  for (const { name: what, count, properties } of header.elements) {
    if (properties.length === 0) continue;
    // In text a value is at least one digit and a blank.
    const row = properties.reduce(
      (sum, p) => sum + (header.encoding === 'ascii' ? 2 : PLY_BYTES[p.countType ?? p.type]),
      0,
    );
    needed += count * row;
    checkAnnounced(
      name,
      `${count} ${PLURALS.get(what) ?? `entries of “${what}”`}`,
      needed - (header.encoding === 'ascii' ? 1 : 0),
      present,
    );
  }
}

function skip(values: PlyValues, { count, properties }: PlyElement): void {
  if (properties.length === 0) return;
  for (let row = 0; row < count; row++)
    for (const { type, countType } of properties) {
      const length = countType ? values.next(countType) : 1;
      for (let i = 0; i < length; i++) values.next(type);
    }
}
