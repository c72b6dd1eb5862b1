import { describe, expect, test } from 'vitest';
import { detectFormat, writeModel } from '../../web/io';
import { bytes, codeOf, codes, makeModel, read, text } from './support';

const TRIANGLE = makeModel([0, 0, 0, 1, 0, 0, 0, 1, 0], [[0, 1, 2]]);
const failing = (content: string | Uint8Array, name: string) => codeOf(() => read(content, name));
const header = (counts: string, format = 'binary_little_endian') =>
  `ply\nformat ${format} 1.0\n${counts}end_header\n`;
const XYZ = 'property float x\nproperty float y\nproperty float z\n';
const LIST = 'property list uchar int vertex_indices\n';

describe('a file that is no model is refused by name', () => {
  test.each([
    ['an empty file', '', 'a.obj', 'file-empty'],
    ['an OBJ of comments', '# nothing here\n', 'a.obj', 'file-not-a-mesh'],
    ['a GIF called PLY', 'GIF89a\x01\0\x01\0\0\0', 'a.ply', 'file-not-a-mesh'],
    ['text called PLY', 'hello', 'a.ply', 'file-not-a-mesh'],
    ['text called nothing', 'hello', 'a.xyz', 'format-unknown'],
    ['a zip archive', 'PK\x03\x04', 'a.3mf', 'format-unsupported'],
    ['an FBX', 'Kaydara FBX Binary  \0', 'a.fbx', 'format-unsupported'],
    ['COLLADA', '<?xml version="1.0"?>', 'a.dae', 'format-unsupported'],
    ['a PLY without vertices', header('element face 0\n'), 'a.ply', 'file-not-a-mesh'],
    [
      'a PLY whose vertices lie in a plane',
      header('element vertex 0\nproperty float x\n'),
      'a.ply',
      'file-not-a-mesh',
    ],
    ['an STL without facets', 'solid a\nendsolid a\n', 'a.stl', 'file-not-a-mesh'],
  ])('%s', (_, content, name, code) => {
    expect(failing(content, name)).toBe(code);
  });
});

describe('a file that was cut short is refused', () => {
  test('in its header', () => {
    expect(failing('ply\nformat ascii 1.0\nelement vertex 26\nproper', 'a.ply')).toBe('file-truncated');
    expect(failing('ply\n', 'a.ply')).toBe('file-truncated');
    expect(failing(writeModel(TRIANGLE, 'stl').subarray(0, 60), 'a.stl')).toBe('file-truncated');
  });

  test.each(['ply', 'stl', 'glb'] as const)('anywhere in a %s', (format) => {
    const whole = writeModel(TRIANGLE, format);
    for (let length = 84; length < whole.length; length++)
      expect(failing(whole.slice(0, length), `a.${format}`), `${length} bytes`).toBe('file-truncated');
  });

  test('anywhere in an ascii PLY or STL, but for its last line end or word', () => {
    for (const format of ['ply', 'stl'] as const) {
      const whole = text(writeModel(TRIANGLE, format, { ascii: true }));
      for (let length = 30; length < whole.length - 12; length++)
        expect(failing(whole.slice(0, length), `a.${format}`), `${length} letters`).toBe('file-truncated');
    }
  });
});

describe('a count that the file cannot hold is refused before memory is set aside', () => {
  test.each([
    ['faces', header(`element vertex 1\n${XYZ}element face 900000000\n${LIST}`) + '\0'.repeat(900), 'a.ply'],
    ['vertices', header(`element vertex 2000000000\n${XYZ}`), 'a.ply'],
    ['vertices in text', header(`element vertex 2000000000\n${XYZ}`, 'ascii'), 'a.ply'],
    [
      'entries of another element',
      header(`element x 2000000000\nproperty char c\nelement vertex 0\n${XYZ}`),
      'a.ply',
    ],
    ['OFF vertices', 'OFF\n700000000 1 0\n0 0 0\n', 'a.off'],
    ['OFF nonsense', 'OFF\nmany 1 0\n0 0 0\n', 'a.off'],
    ['facets', `${' '.repeat(80)}\xff`, 'a.stl'],
  ])('%s', (_, content, name) => {
    const raw = Uint8Array.from(content, (c) => c.charCodeAt(0));
    const file = name === 'a.stl' ? Uint8Array.of(...raw.subarray(0, 80), 255, 255, 255, 127, 1, 2, 3) : raw;
    expect(failing(file, name)).toBe('count-too-large');
  });

  test('glTF values', () => {
    const json = {
      asset: { version: '2.0' },
      accessors: [{ componentType: 5126, count: 2e9, type: 'VEC3' }],
    };
    const scene = { meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }], nodes: [{ mesh: 0 }] };
    expect(failing(JSON.stringify({ ...json, ...scene }), 'a.gltf')).toBe('count-too-large');
  });

  test('an element without properties takes no time, however often it is announced', () => {
    const file = header(`element vertex 1\n${XYZ}element face 900000000\n`, 'ascii');
    expect(codes(`${file}0 0 0\n`)).toEqual(['element-ignored', 'no-faces']);
  });
});

describe('damage is named with its place', () => {
  test('a header line that makes no sense', () => {
    expect(() => read(`ply\nformat ascii 1.0\nelement vertex many\n`)).toThrow(
      /line 3: “element vertex many”/,
    );
    expect(failing('ply\nformat ascii 1.0\nproperty float x\n', 'a.ply')).toBe('file-damaged');
    expect(failing('ply\nformat morse 1.0\n', 'a.ply')).toBe('file-damaged');
    expect(failing('ply\nend_header\n', 'a.ply')).toBe('file-damaged');
  });

  test('a list of impossible length', () => {
    const file = header(
      `element vertex 1\n${XYZ}element face 1\nproperty list int int vertex_indices\n`,
      'ascii',
    );
    expect(() => read(`${file}0 0 0\n-3 1 2\n`)).toThrow(/line 11: a list of -3/);
    expect(failing(`${file}0 0 0\n999999999 1 2\n`, 'a.ply')).toBe('file-truncated');
  });
});

test('the wrong extension is no obstacle, and said so', () => {
  expect(codes(writeModel(TRIANGLE, 'ply'), 'a.stl')).toEqual(['extension-differs']);
  expect(codes(writeModel(TRIANGLE, 'obj'), 'a.ply')).toEqual(['extension-differs']);
  expect(codes(writeModel(TRIANGLE, 'stl', { ascii: true }), 'folder/a.OBJ')).toEqual(['extension-differs']);
  expect(codes(writeModel(TRIANGLE, 'glb'), 'a.gltf')).toEqual(['extension-differs']);
  expect(codes(writeModel(TRIANGLE, 'obj'), 'a.txt')).toEqual([]);
});

test('each format is known by its content', () => {
  for (const format of ['obj', 'ply', 'stl', 'glb', 'gltf'] as const)
    expect(detectFormat(writeModel(TRIANGLE, format), 'a')).toBe(format);
  expect(detectFormat(writeModel(TRIANGLE, 'stl', { ascii: true }), 'a')).toBe('stl');
  expect(detectFormat(bytes('\ufeffv 0 0 0\n'), 'a.obj')).toBe('obj');
});

test('a model without a usable face cannot become triangles', () => {
  const points = makeModel([0, 0, 0], []);
  for (const format of ['stl', 'glb', 'gltf'] as const)
    expect(codeOf(() => writeModel(points, format))).toBe('nothing-to-export');
});
