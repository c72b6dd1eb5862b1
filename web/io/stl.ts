import { LissomError } from '../core/errors';
import type { FaceGroup, Model } from '../core/model';
import { Budget } from './budget';
import { ByteWriter } from './byte-writer';
import { isBinaryStl } from './detect';
import { groupRuns } from './group-runs';
import { GrowingFloat64 } from './growing';
import { faceNormal } from './normals';
import { Notes } from './notes';
import { checkAnnounced, nothingToWrite, type ReadResult } from './reading';
import { decode, TextScanner } from './text-scanner';
import { triangulate } from './triangulate';
import { fromUnitComments, unitComments } from './units-comment';

/** What an STL export puts back: whether the file was text. */
export interface StlExtra {
  readonly ascii: boolean;
}

const HEADER = 80;
const FACET = 50;
/** Bytes that the corners and the place of a facet take once it is read. */
const INDICES = 16;

/**
 * STL, binary or ascii: three vertices of its own for every facet, as in the file. Facet normals and the colour
 * bits some programs hide in a facet's last two bytes are left out.
 *
 * @throws LissomError `file-truncated`, `count-too-large`, `file-not-a-mesh`, `file-too-large`
 */
export function readStl(bytes: Uint8Array, name: string): ReadResult {
  const budget = new Budget('mesh', name, bytes.length);
  const text =
    !isBinaryStl(bytes) && new TextDecoder().decode(bytes.subarray(0, 512)).trimStart().startsWith('solid');
  return text ? readAscii(bytes, name, budget) : readBinary(bytes, name, budget);
}

function readBinary(bytes: Uint8Array, name: string, budget: Budget): ReadResult {
  const notes = new Notes();
  if (bytes.length < HEADER + 4) checkAnnounced(name, 'an STL header', HEADER + 4, bytes.length);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = view.getUint32(HEADER, true);
  checkAnnounced(name, `${count} facets`, count * FACET, bytes.length - HEADER - 4);
  budget.take((72 + INDICES) * count);
  const positions = new Float64Array(9 * count);
  for (let f = 0; f < count; f++)
    for (let k = 0; k < 9; k++)
      positions[9 * f + k] = view.getFloat32(HEADER + 4 + FACET * f + 12 + 4 * k, true);
  return result(name, positions, [], notes, headerComments(bytes), false);
}

const headerComments = (bytes: Uint8Array): string[] => decode(bytes, 0, HEADER).trimEnd().split('; ');

function readAscii(bytes: Uint8Array, name: string, budget: Budget): ReadResult {
  const notes = new Notes();
  const text = new TextScanner(bytes);
  const positions = new GrowingFloat64(budget);
  const groups: FaceGroup[] = [];
  let group = '';
  let start = 0;
  /** Where the numbers of the facet under way begin; what belongs to none is left out. */
  let facetStart: number | undefined;
  let closed = true;
  const close = () => {
    const end = positions.length / 9;
    if (end > start) groups.push({ name: group, start, end });
    start = end;
  };
  const drop = (where: string) => {
    if (facetStart === undefined) return;
    const corners = (positions.length - facetStart) / 3;
    notes.add('facet-not-a-triangle', `A facet with ${corners} corners instead of 3 was left out.`, where);
    positions.length = facetStart;
    facetStart = undefined;
  };
  for (; text.toNextWord(); text.nextLine()) {
    const where = `line ${text.line}`;
    switch (text.word().toLowerCase()) {
      case 'vertex':
        if (facetStart === undefined)
          notes.add('vertex-without-facet', 'A vertex outside of any facet was left out.', where);
        else for (let k = 0; k < 3; k++) positions.push(text.atLineEnd() ? NaN : text.number());
        break;
      case 'facet':
        drop(where);
        facetStart = positions.length;
        break;
      case 'endfacet':
        if (facetStart !== undefined && positions.length - facetStart === 9) facetStart = undefined;
        else drop(where);
        break;
      case 'solid':
        drop(where);
        close();
        group = text.restOfLine();
        closed = false;
        break;
      case 'endsolid':
        drop(where);
        closed = true;
    }
  }
  if (!closed) {
    const message = `${name} ends at line ${text.line} without “endsolid”. It was cut short: fetch it again.`;
    throw new LissomError('file-truncated', message);
  }
  drop(`line ${text.line}`);
  close();
  const named = groups.filter((g) => g.name !== '');
  return result(name, positions.finish(), named, notes, [], true);
}

function result(
  name: string,
  positions: Float64Array,
  groups: FaceGroup[],
  notes: Notes,
  comments: string[],
  ascii: boolean,
): ReadResult {
  const facets = positions.length / 9;
  if (facets === 0) {
    const message = `${name} is an STL file without a facet, so it holds no model. Export it again.`;
    throw new LissomError('file-not-a-mesh', message);
  }
  const extra: StlExtra = { ascii };
  const model: Model = {
    name,
    positions,
    faceOffsets: Uint32Array.from({ length: facets + 1 }, (_, f) => 3 * f),
    faceVertices: Uint32Array.from({ length: 3 * facets }, (_, i) => i),
    ...(groups.length > 0 && { groups }),
    ...fromUnitComments(comments).units,
    origin: { format: 'stl', extra },
  };
  return { model, notes: notes.list() };
}

/**
 * STL: triangles only, so larger faces are cut, and without shared vertices. Binary is single precision; what came
 * as text goes out as text unless told otherwise.
 */
export function writeStl(model: Model, ascii = isFromAscii(model)): Uint8Array {
  return ascii ? writeAscii(model) : writeBinary(model);
}

const isFromAscii = ({ origin }: Model): boolean =>
  origin?.format === 'stl' && (origin.extra as StlExtra).ascii;

function writeBinary(model: Model): Uint8Array {
  const { triangles, corners } = facets(model);
  const count = triangles.length / 3;
  const out = new ByteWriter(HEADER + 4 + FACET * count);
  out.text(['binary STL', ...unitComments(model)].join('; ').slice(0, HEADER).padEnd(HEADER));
  out.u32(count);
  for (let t = 0; t < count; t++) {
    for (const c of unitNormal(model, triangles, t)) out.f32(c);
    for (let k = 0; k < 9; k++) out.f32(corners(t, k));
    out.u16(0);
  }
  return out.finish();
}

function writeAscii(model: Model): Uint8Array {
  const { triangles, faces, corners } = facets(model);
  const out = new ByteWriter(200 * faces.length);
  const runs = groupRuns(model);
  let run = 0;
  const begin = () => out.text(`solid ${oneLine(runs[run]?.name ?? '')}`.trimEnd());
  const end = () => out.text(`\nend${`solid ${oneLine(runs[run]?.name ?? '')}`.trimEnd()}\n`);
  begin();
  for (let t = 0; t < faces.length; t++) {
    for (; run + 1 < runs.length && faces[t]! >= runs[run]!.end; begin()) {
      end();
      run++;
    }
    out.text('\nfacet normal');
    for (const c of unitNormal(model, triangles, t)) putNumber(out, Math.fround(c));
    out.text('\nouter loop\n');
    for (let k = 0; k < 9; k++) {
      if (k % 3 === 0) out.text('vertex');
      putNumber(out, corners(t, k));
      if (k % 3 === 2) out.byte(10);
    }
    out.text('endloop\nendfacet');
  }
  end();
  return out.finish();
}

function facets(model: Model) {
  const { triangles: at, faces } = triangulate(model);
  if (faces.length === 0) throw nothingToWrite(model, 'STL');
  const triangles = at.map((corner) => model.faceVertices[corner]!);
  const corners = (t: number, k: number) =>
    model.positions[3 * triangles[3 * t + Math.floor(k / 3)]! + (k % 3)]!;
  return { triangles, faces, corners };
}

function unitNormal({ positions }: Model, triangles: Uint32Array, t: number): number[] {
  const n = faceNormal(positions, triangles, 3 * t, 3 * t + 3);
  const length = Math.hypot(...n);
  return length > 0 ? n.map((c) => c / length) : [0, 0, 0];
}

function putNumber(out: ByteWriter, value: number): void {
  out.byte(32);
  out.decimal(value);
}

const oneLine = (text: string): string => text.replace(/[\r\n]+/g, ' ');
