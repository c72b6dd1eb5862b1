import { expect, test } from 'vitest';
import { type Model, withPositions } from '../../web/core/model';
import { writeModel } from '../../web/io';
import { bytes, codes, facesOf, galleryFile, makeModel, read, text } from './support';

const ascii = (header: string, body: string) => `ply\nformat ascii 1.0\n${header}end_header\n${body}`;
const XYZ = 'property float x\nproperty float y\nproperty float z\n';
const VERTICES = `element vertex 4\n${XYZ}`;
const POINTS = '0 0 0\n1 0 0\n1 1 0\n0 1 0\n';

test('the index list may be called vertex_index or vertex_indices and have any types', () => {
  for (const list of ['uchar int vertex_indices', 'int32 uint32 vertex_index', 'ushort short vertex_indices'])
    expect(
      facesOf(
        read(ascii(`${VERTICES}element face 2\nproperty list ${list}\n`, `${POINTS}4 0 1 2 3\n3 0 1 2\n`)),
      ),
    ).toEqual([
      [0, 1, 2, 3],
      [0, 1, 2],
    ]);
});

test.each(['\n', '\r\n', '\r'])('headers and rows may end in %j', (end) => {
  const source = ascii(
    `${VERTICES}element face 1\nproperty list uchar int vertex_index\n`,
    `${POINTS}3 0 1 2\n`,
  );
  expect(facesOf(read(source.replaceAll('\n', end)))).toEqual([[0, 1, 2]]);
});

test('a binary body begins right after the header, whichever line end it has', () => {
  for (const end of ['\n', '\r\n']) {
    const header = bytes(
      [
        'ply',
        'format binary_big_endian 1.0',
        'element vertex 1',
        ...XYZ.trim().split('\n'),
        'end_header',
        '',
      ].join(end),
    );
    const file = new Uint8Array(header.length + 12);
    file.set(header);
    // The first byte is a line feed, which must not be taken for one.
    file.set([0x0a, 0, 0, 0, 0x40, 0, 0, 0, 0xc0, 0, 0, 0], header.length);
    expect([...read(file).positions.subarray(1)]).toEqual([2, -2]);
  }
});

test('both byte orders and text hold the same model', () => {
  const model: Model = {
    ...makeModel(
      [0, 0.1, 1e300, 1, 2, 3, -4, 5, -6e-300, 7, 8, 9],
      [
        [0, 1, 2, 3],
        [3, 1, 0],
      ],
    ),
    colors: Uint8Array.from({ length: 16 }, (_, i) => 15 * i),
    colorAlpha: true,
  };
  const little = writeModel(model, 'ply');
  const big = swapped(little, 4);
  const want = read(little);
  expect(read(big)).toEqual(want);
  expect(read(writeModel(model, 'ply', { ascii: true }))).toEqual(want);
});

/** A file of `writeModel` for vertices x y z r g b a and faces of 4 and 3 corners, in the other byte order. */
function swapped(file: Uint8Array, vertices: number): Uint8Array {
  const start = text(file).indexOf('end_header\n') + 11;
  const header = bytes(text(file.subarray(0, start)).replace('little', 'big'));
  const body = file.slice(start);
  const turn = (at: number, size: number) => body.subarray(at, at + size).reverse();
  let at = 0;
  for (let v = 0; v < vertices; v++, at += 4) for (let k = 0; k < 3; k++, at += 8) turn(at, 8);
  for (const size of [4, 3]) {
    at++;
    for (let k = 0; k < size; k++, at += 4) turn(at, 4);
  }
  const out = new Uint8Array(header.length + body.length);
  out.set(header);
  out.set(body, header.length);
  return out;
}

test('triangle strips are unfolded with alternating sides, new ones beginning after −1', () => {
  const source = ascii(
    `element vertex 6\n${XYZ}element tristrips 1\nproperty list int int vertex_indices\n`,
    `${'0 0 0\n'.repeat(6)}9 0 1 2 3 -1 2 3 4 5\n`,
  );
  expect(facesOf(read(source))).toEqual([
    [0, 1, 2],
    [2, 1, 3],
    [2, 3, 4],
    [4, 3, 5],
  ]);
  expect(codes(source)).toEqual(['strips-unfolded']);
});

test('colours may be bytes or fractions, with or without alpha', () => {
  const colored = (type: string, values: string, names = ['red', 'green', 'blue']) =>
    read(
      ascii(
        `element vertex 1\n${XYZ}${names.map((n) => `property ${type} ${n}\n`).join('')}`,
        `0 0 0 ${values}\n`,
      ),
    );
  expect([...colored('uchar', '1 2 3').colors!]).toEqual([1, 2, 3, 255]);
  expect([...colored('float', '0 0.5 1').colors!]).toEqual([0, 128, 255, 255]);
  expect([...colored('ushort', '0 257 65535').colors!]).toEqual([0, 1, 255, 255]);
  const alpha = colored('uchar', '1 2 3 4', ['red', 'green', 'blue', 'alpha']);
  expect([[...alpha.colors!], alpha.colorAlpha]).toEqual([[1, 2, 3, 4], true]);
});

test.each([
  ['s', 't'],
  ['u', 'v'],
  ['texture_u', 'texture_v'],
])('texture coordinates may be %s and %s', (s, t) => {
  const source = ascii(
    `element vertex 1\n${XYZ}property float ${s}\nproperty float ${t}\n`,
    '0 0 0 0.25 0.75\n',
  );
  expect([...read(source).uvs!]).toEqual([0.25, 0.75]);
});

test('texture coordinates per corner are looked up per corner', () => {
  const source = ascii(
    `${VERTICES}element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n`,
    `${POINTS}3 0 1 2 6 0 0 1 0 1 1\n`,
  );
  const model = read(source);
  expect([...model.uvs!]).toEqual([0, 0, 1, 0, 1, 1]);
  expect([...model.uvIndices!]).toEqual([0, 1, 2]);
});

test('a byte property of zeros and ones is a vertex set', () => {
  const source = ascii(
    `element vertex 3\n${XYZ}property uchar scalp\nproperty uchar grade\n`,
    '0 0 0 1 7\n0 0 0 0 1\n0 0 0 1 0\n',
  );
  expect(read(source).vertexSets).toEqual({ scalp: Uint32Array.of(0, 2) });
});

test('properties without a meaning here, comments and the wish for normals survive; normals are new', () => {
  const source = ascii(
    `comment made by hand\n${VERTICES}property float nx\nproperty float ny\nproperty float nz\nproperty double quality\n` +
      'element face 2\nproperty int tag\nproperty list uchar int vertex_indices\n',
    '0 0 0 1 0 0 0.1\n1 0 0 1 0 0 0.2\n1 1 0 1 0 0 0.3\n0 1 0 1 0 0 0.4\n5 3 0 1 2\n6 3 0 2 3\n',
  );
  const model = read(source, 'a.ply');
  const again = text(writeModel(model, 'ply', { ascii: true }));
  expect(again).toContain('comment made by hand\n');
  expect(again).toContain('\n1 1 0 0 0 1 0.3 \n');
  expect(again).toContain('\n3 0 2 3 6 \n');
  expect(read(again, 'a.ply')).toEqual(model);
});

test('other elements are passed over and said so', () => {
  const source = ascii(
    `element camera 2\nproperty list uchar float m\nproperty int k\n${VERTICES}element edge 1\nproperty int vertex1\nproperty int vertex2\n`,
    `2 1 2 3\n0 4\n${POINTS}0 1\n`,
  );
  expect([...read(source).positions]).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
  expect(codes(source)).toEqual(['element-ignored', 'no-faces']);
});

test('a polygon of 200 corners with texture coordinates fits', () => {
  const ring = Array.from({ length: 200 }, (_, i) => i);
  const model = makeModel(
    ring.flatMap((i) => [Math.cos(i), Math.sin(i), 0]),
    [ring],
  );
  const textured = {
    ...model,
    uvs: Float64Array.from(ring.flatMap((i) => [i, i])),
    uvIndices: Uint32Array.from(ring),
  };
  expect(facesOf(read(writeModel(textured, 'ply')))).toEqual([ring]);
});

test('moving a model in a PLY keeps everything but its coordinates', () => {
  const head = read(galleryFile('head-elf.ply'), 'head-elf.ply');
  const moved = withPositions(
    head,
    head.positions.map((c) => 2 * c),
  );
  const { positions, ...rest } = read(writeModel(moved, 'ply'), 'head-elf.ply');
  const { positions: _, ...expected } = head;
  expect(rest).toEqual(expected);
  expect(positions).toEqual(moved.positions);
});
