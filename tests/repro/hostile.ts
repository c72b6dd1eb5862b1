// Inputs that cost more than they look, as they were found: for the tests that name them, and for the page to refuse.

import { deflateSync, zipSync } from 'fflate';
import { toBase64Url } from '../../web/core/base64url';
import { crc32 } from '../../web/core/crc32';
import { ByteWriter } from '../../web/recipe/link/bytes';
import { encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import { bytes } from '../io/support';

export const LIST = 5;
export const NUMBERS = 7;
export const TABLE = 8;
const EACH_ALONE = 31;

/** A link whose head and checksum are right around any content. */
export function sealed(write: (out: ByteWriter) => void): string {
  const plain = new ByteWriter();
  write(plain);
  const body = new ByteWriter();
  body.varint(plain.done().length);
  body.raw(deflateSync(plain.done(), { level: 9 }));
  const packed = body.done();
  const { length } = packed;
  const out = new ByteWriter();
  out.byte(1);
  out.byte(crc32(Uint8Array.of(1, length & 255, (length >>> 8) & 255, length >>> 16)) & 255);
  out.varint(length);
  for (const shift of [0, 8, 16, 24]) out.byte((crc32(packed) >>> shift) & 255);
  out.raw(packed);
  return `#r=${toBase64Url(out.done())}`;
}

/** A list of tables whose rows hold no numbers. */
export function tablesOfNothing(tables = 100_000): string {
  return sealed((out) => {
    out.byte(LIST);
    out.varint(tables);
    for (let i = 0; i < tables; i++) {
      out.byte(TABLE);
      out.varint(400_000);
      out.varint(0);
      out.byte(EACH_ALONE);
    }
  });
}

/** A handle that names twenty thousand times the same thirty thousand vertices. */
export function equalRanges(): string {
  const vertices = { ranges: Array.from({ length: 20_000 }, () => [0, 29_781] as const) };
  const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const handles = [{ kind: 'region', vertices, matrix }];
  const steps = [{ id: 'd', type: 'deform', model: 'm', handles }];
  return encodeLink(parseRecipe({ lissom: 1, models: { m: { builtin: 'dinosaur' } }, steps }));
}

export const base64 = (content: Uint8Array): string =>
  `data:application/octet-stream;base64,${Buffer.from(content).toString('base64')}`;

/** glTF whose every node shows the same mesh. */
export function instances(nodes: number, vertices: number, primitives = 1): Uint8Array {
  const buffer = new Uint8Array(12 * vertices);
  const primitive = { attributes: { POSITION: 0 } };
  return bytes(
    JSON.stringify({
      asset: { version: '2.0' },
      scenes: [{ nodes: Array.from({ length: nodes }, (_, i) => i) }],
      nodes: Array.from({ length: nodes }, () => ({ mesh: 0 })),
      meshes: [{ primitives: Array.from({ length: primitives }, () => primitive) }],
      accessors: [{ bufferView: 0, componentType: 5126, count: vertices, type: 'VEC3' }],
      bufferViews: [{ buffer: 0, byteLength: buffer.length }],
      buffers: [{ byteLength: buffer.length, uri: base64(buffer) }],
    }),
  );
}

/** An archive with 999 entries over one block. */
export const manyEntries = (): Uint8Array =>
  overlapping(zipSync({ 'recipe.json': bytes('{}'), 'a.ply': new Uint8Array(1_000_000) }), 999);

/** An archive of less than 3 MB that announces a recipe of 60. */
export function longRecipe(): Uint8Array {
  // Declared, not packed: what it says is asked before what it holds.
  const file = zipSync({
    'project/recipe.json': new Uint8Array(1_000_000),
    'project/a.ply': noise(2_000_000),
  });
  const view = new DataView(file.buffer);
  view.setUint32(view.getUint32(file.length - 6, true) + 24, 60_000_000, true);
  return file;
}

/** The last entry of an archive's directory repeated, each time under another name of the same length. */
export function overlapping(zip: Uint8Array, times: number): Uint8Array {
  const view = new DataView(zip.buffer);
  const end = zip.length - 22;
  const directory = view.getUint32(end + 16, true);
  const first = 46 + view.getUint16(directory + 28, true);
  const last = zip.slice(directory + first, end);
  const copies = Array.from({ length: times - 1 }, (_, i) => {
    const copy = last.slice();
    copy.set(bytes(i.toString(36).padStart(5, 'b')), 46);
    return copy;
  });
  const tail = zip.slice(end);
  const out = Buffer.concat([zip.slice(0, directory + first), ...copies, tail]);
  const size = out.length - 22 - directory;
  for (const [at, value] of [
    [8, times],
    [10, times],
  ] as const)
    out.writeUInt16LE(value, out.length - 22 + at);
  out.writeUInt32LE(size, out.length - 22 + 12);
  return new Uint8Array(out);
}

/** Bytes that do not pack. */
function noise(length: number): Uint8Array {
  let state = 1;
  return Uint8Array.from({ length }, () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state >>> 24;
  });
}
