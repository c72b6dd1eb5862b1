import { faceCount, type Model, vertexCount } from '../core/model';
import { ByteWriter } from './byte-writer';
import { vertexNormals } from './normals';
import { PLY_BYTES, type PlyType } from './ply-header';
import type { PlyExtra } from './ply-read';
import type { PlyColumn } from './ply-vertices';
import { NO_INDEX } from './reading';
import { unitComments } from './units-comment';

const AXES = ['x', 'y', 'z'];
const NORMALS = ['nx', 'ny', 'nz'];
const COLORS = ['red', 'green', 'blue', 'alpha'];

/** One property and its value in a row. */
interface Column {
  readonly name: string;
  readonly type: PlyType;
  readonly value: (row: number) => number;
}

/**
 * Stanford PLY with positions in double precision: binary little endian, or ascii with as many digits as bring
 * back the same number. Faces that name a missing vertex keep their numbers.
 */
export function writePly(model: Model, ascii = false): Uint8Array {
  const extra = model.origin?.format === 'ply' ? (model.origin.extra as PlyExtra) : undefined;
  const vertexColumns = columnsOfVertices(model, extra);
  const faceColumns = (extra?.faceColumns ?? [])
    .filter((c) => c.values.length === faceCount(model))
    .map(asColumn);
  const out = new ByteWriter(1024 + 32 * vertexCount(model) + 5 * model.faceVertices.length);
  const put = ascii ? putText : putBinary;
  const list = countTypeOf(model);
  const wedge = model.uvs && model.uvIndices ? typeFor(model.uvs) : undefined;

  out.text(`ply\nformat ${ascii ? 'ascii' : 'binary_little_endian'} 1.0\n`);
  for (const comment of [...unitComments(model), ...(extra?.comments ?? [])])
    out.text(comment ? `comment ${comment}\n` : 'comment\n');
  out.text(`element vertex ${vertexCount(model)}\n`);
  for (const { name, type } of vertexColumns) out.text(`property ${type} ${name}\n`);
  out.text(`element face ${faceCount(model)}\nproperty list ${list} int vertex_indices\n`);
  if (wedge) out.text(`property list ${list} ${wedge} texcoord\n`);
  for (const { name, type } of faceColumns) out.text(`property ${type} ${name}\n`);
  out.text('end_header\n');

  for (let v = 0; v < vertexCount(model); v++) {
    for (const { type, value } of vertexColumns) put(out, type, value(v));
    if (ascii) out.byte(10);
  }
  const { faceOffsets, faceVertices } = model;
  for (let f = 0; f < faceCount(model); f++) {
    const start = faceOffsets[f]!;
    const end = faceOffsets[f + 1]!;
    put(out, list, end - start);
    for (let i = start; i < end; i++) put(out, 'int', faceVertices[i]! | 0);
    if (wedge) putWedge(out, put, model, f, list, wedge);
    for (const { type, value } of faceColumns) put(out, type, value(f));
    if (ascii) out.byte(10);
  }
  return out.finish();
}

function columnsOfVertices(model: Model, extra: PlyExtra | undefined): Column[] {
  const { positions, colors, colorAlpha, uvs, uvIndices, vertexSets } = model;
  const columns = strided(AXES, 'double', positions);
  if (extra?.normals) columns.push(...strided(NORMALS, 'float', vertexNormals(model)));
  if (colors) columns.push(...strided(COLORS, 'uchar', colors).slice(0, colorAlpha ? 4 : 3));
  if (uvs && !uvIndices) columns.push(...strided(['s', 't'], typeFor(uvs), uvs));
  const taken = new Set(columns.map((c) => c.name));
  for (const [name, set] of Object.entries(vertexSets ?? {}))
    columns.push(setColumn(freeName(name, taken), set, vertexCount(model)));
  for (const column of extra?.vertexColumns ?? [])
    if (column.values.length === vertexCount(model) && !taken.has(column.name))
      columns.push(asColumn(column));
  return columns;
}

const strided = (names: readonly string[], type: PlyType, values: Float64Array | Uint8Array): Column[] =>
  names.map((name, offset) => ({ name, type, value: (row) => values[names.length * row + offset]! }));

const asColumn = ({ name, type, values }: PlyColumn): Column => ({
  name,
  type,
  value: (row) => values[row]!,
});

function setColumn(name: string, set: Uint32Array, count: number): Column {
  const inside = new Uint8Array(count);
  for (const v of set) if (v < count) inside[v] = 1;
  return { name, type: 'uchar', value: (row) => inside[row]! };
}

/** A property name without blanks that no other property has. */
function freeName(name: string, taken: Set<string>): string {
  const stem = name.trim().replace(/\s+/g, '_') || 'set';
  let free = stem;
  for (let k = 2; taken.has(free); k++) free = `${stem}_${k}`;
  taken.add(free);
  return free;
}

/** Single precision where it loses nothing: more programs read it. */
function typeFor(values: Float64Array): PlyType {
  return values.every((value) => Object.is(Math.fround(value), value)) ? 'float' : 'double';
}

/** The list length's type: two values per corner must fit as well. */
function countTypeOf({ faceOffsets }: Model): PlyType {
  let most = 0;
  for (let f = 1; f < faceOffsets.length; f++) most = Math.max(most, faceOffsets[f]! - faceOffsets[f - 1]!);
  return 2 * most < 256 ? 'uchar' : 'int';
}

type Put = (out: ByteWriter, type: PlyType, value: number) => void;

function putWedge(out: ByteWriter, put: Put, model: Model, f: number, list: PlyType, type: PlyType): void {
  const [start, end] = [model.faceOffsets[f]!, model.faceOffsets[f + 1]!];
  const indices = model.uvIndices!.subarray(start, end);
  if (indices.includes(NO_INDEX)) {
    put(out, list, 0);
    return;
  }
  put(out, list, 2 * indices.length);
  for (const i of indices) {
    put(out, type, model.uvs![2 * i]!);
    put(out, type, model.uvs![2 * i + 1]!);
  }
}

const putText: Put = (out, _, value) => {
  out.decimal(value);
  out.byte(32);
};

const putBinary: Put = (out, type, value) => {
  if (type === 'double') out.f64(value);
  else if (type === 'float') out.f32(value);
  else if (PLY_BYTES[type] === 4) out.u32(value);
  else if (PLY_BYTES[type] === 2) out.u16(value);
  else out.byte(value);
};
