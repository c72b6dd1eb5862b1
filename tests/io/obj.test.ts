import { expect, test } from 'vitest';
import { withPositions } from '../../web/core/model';
import { writeModel } from '../../web/io';
import { codes, facesOf, read, text } from './support';

const SQUARE = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';

test('indices count from one, or back from the newest vertex', () => {
  expect(facesOf(read(`${SQUARE}f 1 2 3 4\nf -4 -3 -2\nv 9 9 9\nf -1 -2 -3\n`))).toEqual([
    [0, 1, 2, 3],
    [0, 1, 2],
    [4, 3, 2],
  ]);
});

test('corners are v, v/vt, v//vn or v/vt/vn, mixed at will', () => {
  const model = read(`${SQUARE}vt 0 0.5\nvt 1 0.25\nvn 0 0 1\nf 1/1 2//1 3/2/1\nf 1 3/-1/-1 4\n`);
  expect(facesOf(model)).toEqual([
    [0, 1, 2],
    [0, 2, 3],
  ]);
  expect(model.uvs).toEqual(Float64Array.of(0, 0.5, 1, 0.25));
  const none = 0xffffffff;
  expect(model.uvIndices).toEqual(Uint32Array.of(0, none, 1, none, 1, none));
});

test.each(['\n', '\r\n', '\r'])('lines may end in %j, be indented, continued and blank', (end) => {
  const lines = ['# c', '', '  v 0 0 0', '\tv 1\t0 0 ', 'v 1 1 \\', '0', 'v 0 1 0', 'f 1 2 \\', '  3 4'];
  const model = read(lines.join(end), 'a.obj');
  expect(facesOf(model)).toEqual([[0, 1, 2, 3]]);
  expect([...model.positions.subarray(6, 9)]).toEqual([1, 1, 0]);
});

test('colours behind the coordinates are 0–1 or 0–255, and a single fourth number is a weight', () => {
  const faces = 'f 1 2 3\n';
  const unit = read(`v 0 0 0 1 0 0.5\nv 1 0 0 0 1 0\nv 0 1 0\n${faces}`);
  expect([...unit.colors!]).toEqual([255, 0, 128, 255, 0, 255, 0, 255, 255, 255, 255, 255]);
  expect(unit.colorAlpha).toBe(false);
  const bytes = read(`v 0 0 0 255 0 7\nv 1 0 0 0 1 0\nv 0 1 0 1 1 1\n${faces}`);
  expect([...bytes.colors!.subarray(0, 8)]).toEqual([255, 0, 7, 255, 0, 1, 0, 255]);
  expect(read(`v 0 0 0 1.0\nv 1 0 0\nv 0 1 0\n${faces}`).colors).toBeUndefined();
});

test('objects, groups and materials are runs of faces, and go out as they came in', () => {
  const source = `# made by hand\nmtllib a.mtl\n${SQUARE}o thing\nf 1 2 3\ng a b\nusemtl red\ns 1\nf 1 3 4\nf 1 2 4\nusemtl blue\nf 2 3 4\n`;
  const model = read(source, 'a.obj');
  expect(model.groups).toEqual([
    { name: 'thing', start: 0, end: 1 },
    { name: 'a b', material: 'red', start: 1, end: 3 },
    { name: 'a b', material: 'blue', start: 3, end: 4 },
  ]);
  expect(text(writeModel(model, 'obj'))).toBe(source);
});

test('groups that came from elsewhere become OBJ groups', () => {
  const model = read(`${SQUARE}g a\nusemtl m\nf 1 2 3\nf 1 3 4\n`, 'a.obj');
  const { origin: _, ...plain } = model;
  expect(read(writeModel(plain, 'obj'), 'b.obj').groups).toEqual(model.groups);
});

test('lines, points and faces of two corners are left out and said so', () => {
  const source = `${SQUARE}l 1 2\np 1\nf 1 2\nf 1 2 3\ncurv 0 1\n`;
  expect(codes(source, 'a.obj')).toEqual(['lines-left-out', 'face-too-short', 'statement-ignored']);
  expect(facesOf(read(source))).toEqual([[0, 1, 2]]);
});

test('what is no number or no vertex stays in place for the kernel to report', () => {
  const source = 'v 0 0 0\nv nan 0 0\nv 0 oops 0\nv 1 1 inf\nv 1 2\nf 1 2 3\nf 1 3 99\nf 0 1 -9\n';
  const model = read(source, 'a.obj');
  expect([...model.positions.subarray(3)]).toEqual([NaN, 0, 0, 0, NaN, 0, 1, 1, Infinity, 1, 2, NaN]);
  expect(facesOf(model)[1]).toEqual([0, 2, 98]);
  expect(facesOf(model)[2]).toEqual([0xffffffff, 0, 0xffffffff]);
  expect(codes(source, 'a.obj')).toEqual(['number-unreadable', 'coordinate-missing']);
});

test('a texture coordinate that is missing leaves its corner without', () => {
  const source = `${SQUARE}vt 0 0\nf 1/1 2/7 3/1\n`;
  expect([...read(source).uvIndices!]).toEqual([0, 0xffffffff, 0]);
  expect(codes(source, 'a.obj')).toEqual(['texture-index-out-of-range']);
});

test('moved vertices change the v lines alone', () => {
  const source = `${SQUARE}vt 0 0\ng a\nf 1/1 2/1 3/1 4/1\n`;
  const model = read(source, 'a.obj');
  const moved = text(
    writeModel(
      withPositions(
        model,
        model.positions.map((c) => c + 0.1),
      ),
      'obj',
    ),
  );
  expect(moved.split('\n').filter((l) => !l.startsWith('v '))).toEqual(
    source.split('\n').filter((l) => !l.startsWith('v ')),
  );
  expect(moved).toContain('v 1.1 0.1 0.1\n');
});

test('an odd but legal file has its three faces, the last with five corners and over two lines', () => {
  const source = [
    ...['mtllib none.mtl', 'o odd', 'v 0 0 0 1.0', 'v 1 0 0', 'v 1 1 0', 'v 0 1 0', 'v 0.5 1.5 0'],
    ...['vt 0 0', 'vt 1 0', 'vn 0 0 1', 'g a b', 's 1', 'f 1/1/1 2/2/1 3/2/1 4/1/1', 'f -3//1 -2//1 -1//1'],
    ...[
      'v 0 0 1',
      'v 1 0 1',
      'v 1 1 1',
      'v 0.5 1.5 1',
      'v 0 1 1',
      'f -5 -4 -3 \\',
      '-2 -1',
      'l 1 2 3',
      'p 1',
    ],
  ];
  expect(facesOf(read(source.join('\n'), 'odd.obj'))).toEqual([
    [0, 1, 2, 3],
    [2, 3, 4],
    [5, 6, 7, 8, 9],
  ]);
});
