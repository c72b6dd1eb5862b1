import { zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { readProject, writeProject } from '../../web/io';
import { bytes, codeOf } from './support';

const recipeJson = '{"lissom":1,"name":"grün"}';
const files = new Map([
  ['bar.ply', Uint8Array.from({ length: 50000 }, (_, i) => (i * i) & 255)],
  ['folder/émpty.obj', new Uint8Array()],
]);
const opening = (entries: Record<string, Uint8Array>) => codeOf(() => readProject(zipSync(entries)));
const RECIPE = { 'recipe.json': bytes(recipeJson) };

test('a project comes back as it was, and equal projects are equal files', () => {
  const packed = writeProject({ recipeJson, files });
  expect(readProject(packed)).toEqual({ recipeJson, files });
  expect(writeProject({ recipeJson, files })).toEqual(packed);
});

test('a project that a system packed again, in a folder and with clutter, opens', () => {
  const packed = zipSync({
    'my project/recipe.json': bytes(recipeJson),
    'my project/a.ply': bytes('ply'),
    'my project/': new Uint8Array(),
    '__MACOSX/my project/._a.ply': bytes('x'),
    'my project/.DS_Store': bytes('x'),
  });
  expect(readProject(packed)).toEqual({ recipeJson, files: new Map([['a.ply', bytes('ply')]]) });
});

test.each(['../a.ply', '/a.ply', 'a/../../b', 'C:a.ply', 'a\\b', 'a//b', './a', 'a\nb'])(
  'a file called %j is refused on the way in and out',
  (name) => {
    expect(opening({ ...RECIPE, [name]: bytes('x') })).toBe('zip-unsafe-name');
    expect(codeOf(() => writeProject({ recipeJson, files: new Map([[name, bytes('x')]]) }))).toBe(
      'zip-unsafe-name',
    );
  },
);

test('an archive without a recipe is no project, and neither is another file', () => {
  expect(opening({ 'a.ply': bytes('ply') })).toBe('project-without-recipe');
  expect(codeOf(() => readProject(bytes('ply\nformat ascii 1.0\n')))).toBe('zip-damaged');
  expect(codeOf(() => readProject(new Uint8Array()))).toBe('file-empty');
  expect(codeOf(() => writeProject({ recipeJson, files: new Map([['recipe.json', bytes('')]]) }))).toBe(
    'zip-unsafe-name',
  );
});

test('a project cut short anywhere is refused', () => {
  const packed = writeProject({ recipeJson, files: new Map([['a.ply', bytes('ply\n')]]) });
  for (let length = 1; length < packed.length; length++)
    expect(
      codeOf(() => readProject(packed.slice(0, length))),
      `${length} bytes`,
    ).toBe('zip-damaged');
});

test('a changed byte of content is noticed', () => {
  const packed = writeProject({ recipeJson, files: new Map() });
  const start = 30 + 'recipe.json'.length;
  for (let at = start; at < start + 10; at++) {
    const broken = packed.slice();
    broken[at]! ^= 16;
    expect(
      codeOf(() => readProject(broken)),
      `byte ${at}`,
    ).toBe('zip-damaged');
  }
});

test('more bytes or files than allowed are refused, whatever is declared', () => {
  const packed = zipSync({ ...RECIPE, 'zeros.ply': new Uint8Array(1e6) });
  const limits = { bytes: 100000, files: 10 };
  expect(codeOf(() => readProject(packed, limits))).toBe('zip-too-large');
  expect(codeOf(() => readProject(packed, { bytes: 1e9, files: 1 }))).toBe('zip-too-large');
  const view = new DataView(packed.buffer);
  let directory = view.getUint32(packed.length - 22 + 16, true);
  directory += 46 + 'recipe.json'.length;
  view.setUint32(directory + 24, 500, true);
  expect(codeOf(() => readProject(packed, limits))).toBe('zip-damaged');
  view.setUint32(directory + 24, 2e7, true);
  expect(codeOf(() => readProject(packed))).toBe('zip-damaged');
  view.setUint32(directory + 24, 4e8, true);
  expect(codeOf(() => readProject(packed))).toBe('zip-too-large');
});
