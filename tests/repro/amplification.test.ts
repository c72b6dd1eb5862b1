// Small files that unfolded to gigabytes: a mesh shown by thousands of nodes, accessors of nothing, a thousand entries of
// an archive over one block, zeros packed two hundred times smaller.

import { zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { readModel, readProject } from '../../web/io';
import { allowance, Budget, checkSize, type FileKind } from '../../web/io/budget';
import { bytes } from '../io/support';
import { refusal } from './bounded';
import { base64, instances, longRecipe, manyEntries, overlapping } from './hostile';

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
  const file = manyEntries();
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
  const file = longRecipe();
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
