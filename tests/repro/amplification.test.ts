// Small files that unfolded to gigabytes: a mesh shown by thousands of nodes, accessors of nothing, a thousand entries of
// an archive over one block, zeros packed two hundred times smaller.

import { zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { readModel, readProject } from '../../web/io';
import { allowance, Budget, checkSize, type FileKind } from '../../web/io/budget';
import { bytes } from '../io/support';
import { refusal } from './bounded';

const base64 = (content: Uint8Array): string =>
  `data:application/octet-stream;base64,${Buffer.from(content).toString('base64')}`;

/** glTF whose every node shows the same mesh. */
function instances(nodes: number, vertices: number, primitives = 1): Uint8Array {
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

/** What was set aside, at most eight bytes a value, within what the file may unfold to. */
const within = (made: number, kind: FileKind, size: number) =>
  expect(8 * made).toBeLessThan(2 * allowance(kind, size));

test('glTF that shows one mesh ten thousand times', () => {
  const file = instances(10_000, 3000);
  const { code, message, made } = refusal(`instances, ${file.length} bytes`, () => readModel(file, 'a.gltf'));
  expect(code).toBe('file-unfolds-too-far');
  expect(message).toMatch(
    /^a\.gltf has \d+ kB and unfolds to more than \d+ MB, which is refused: it repeats .*\.$/,
  );
  within(made, 'gltf', file.length);
});

test('glTF that shows ten thousand primitives without a vertex a thousand times', () => {
  const file = instances(1000, 0, 10_000);
  const { code } = refusal('empty primitives', () => readModel(file, 'a.gltf'));
  expect(code).toBe('file-unfolds-too-far');
});

test('glTF whose accessors have no view', () => {
  const parts = Array.from({ length: 2000 }, (_, i) => ({ attributes: { POSITION: i } }));
  const json = {
    asset: { version: '2.0' },
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: parts }],
    accessors: parts.map(() => ({ componentType: 5126, count: 100_000, type: 'VEC3' })),
    buffers: [{ byteLength: 9000, uri: base64(new Uint8Array(9000)) }],
  };
  const file = bytes(JSON.stringify(json));
  const { code, made } = refusal('accessors of zeros', () => readModel(file, 'a.gltf'));
  expect(code).toBe('file-unfolds-too-far');
  within(made, 'gltf', file.length);
});

test('a zip archive with 999 entries over one block', () => {
  const one = zipSync({ 'recipe.json': bytes('{}'), 'a.ply': new Uint8Array(1_000_000) });
  const file = overlapping(one, 999);
  expect(file.length).toBeLessThan(100_000);
  const { code, message, made } = refusal(`999 entries, ${file.length} bytes`, () => readProject(file));
  expect(code).toBe('zip-too-large');
  expect(message).toMatch(/^The archive unpacks to more than \d+ MB or 1000 files, which is refused\. /);
  expect(made).toBeLessThan(1000);
});

test('entries that share their bytes are refused however little they hold', () => {
  const one = zipSync({ 'recipe.json': bytes('{}'), 'a.ply': bytes('ply '.repeat(100)) });
  const { code, message } = refusal('shared bytes', () => readProject(overlapping(one, 20)));
  expect(code).toBe('zip-damaged');
  expect(message).toMatch(/“.*” and “.*” share their bytes/);
});

test('a recipe of 600 MB in an archive of less than 3', () => {
  // Declared, not packed: what it says is asked before what it holds.
  const file = zipSync({
    'project/recipe.json': new Uint8Array(1_000_000),
    'project/a.ply': noise(2_000_000),
  });
  const view = new DataView(file.buffer);
  view.setUint32(view.getUint32(file.length - 6, true) + 24, 60_000_000, true);
  const { code, message, made } = refusal(`a large recipe, ${file.length} bytes`, () => readProject(file));
  expect(code).toBe('zip-too-large');
  expect(message).toContain('“project/recipe.json” in the archive has 60 MB; the limit is 32 MB.');
  expect(made).toBeLessThan(1000);
});

test('an OBJ of a million lines that are kept as they are is counted line by line', () => {
  const lines = 40_000_000;
  const budget = new Budget('mesh', 'a.obj', 2 * lines);
  expect(() => {
    for (let i = 0; i < lines; i++) budget.take(80);
  }).toThrow(expect.objectContaining({ code: 'file-unfolds-too-far' }));
  expect(budget.taken).toBeLessThanOrEqual(allowance('mesh', 2 * lines) + 80);
});

test.each<FileKind>(['mesh', 'gltf', 'strands', 'project', 'recipe', 'picture'])(
  'a file of kind %s that nothing could hold is refused by its size',
  (kind) => {
    const { code, message } = refusal(`a ${kind} of 3 GB`, () => checkSize(kind, 'a.x', 3e9));
    expect(code).toBe('file-too-large');
    expect(message).toMatch(
      /^a\.x has 3000 MB; the limit is \d+ MB\. Open a smaller file, or a part of it\.$/,
    );
  },
);

/** The last entry of an archive's directory repeated, each time under another name of the same length. */
function overlapping(zip: Uint8Array, times: number): Uint8Array {
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
