import { expect, test } from 'vitest';
import { writeModel } from '../../web/io';
import { bytes, codes, facesOf, makeModel, read, text } from './support';

const SQUARE = makeModel([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [[0, 1, 2, 3]]);

test('a binary STL may begin with the word solid', () => {
  const file = writeModel(SQUARE, 'stl');
  file.set(bytes('solid facet outer loop'));
  expect(read(file, 'a.stl').positions.length).toBe(18);
});

test('every facet keeps vertices of its own', () => {
  const model = read(writeModel(SQUARE, 'stl'), 'a.stl');
  expect(facesOf(model)).toEqual([
    [0, 1, 2],
    [3, 4, 5],
  ]);
});

test('the solids of an ascii STL are groups, and text goes out as text', () => {
  const facet =
    'FACET normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 0 1e0 0\n endloop\nendfacet\n';
  const source = `solid left part\n${facet}${facet}endsolid left part\nsolid right\n${facet}endsolid\n`;
  const model = read(source.replaceAll('\n', '\r\n'), 'a.stl');
  expect(model.groups).toEqual([
    { name: 'left part', start: 0, end: 2 },
    { name: 'right', start: 2, end: 3 },
  ]);
  const again = writeModel(model, 'stl');
  expect(text(again)).toMatch(/^solid left part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n/);
  expect(read(again, 'a.stl')).toEqual(model);
});

test('facets of an ascii STL with another number of corners are left out and said so', () => {
  const source = `solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n${text(
    writeModel(SQUARE, 'stl', { ascii: true }),
  ).slice(6)}`;
  expect(read(source, 'a.stl').positions.length).toBe(18);
  expect(codes(source, 'a.stl')).toEqual(['facet-not-a-triangle']);
});

test('unit and axis travel in the header of a binary STL', () => {
  const model = { ...SQUARE, unitMetres: 0.001, upAxis: 'z' as const };
  expect(read(writeModel(model, 'stl'), 'a.stl')).toMatchObject({ unitMetres: 0.001, upAxis: 'z' });
});

test('faces with corners that are missing or not finite do not go into an STL', () => {
  const model = makeModel(
    [0, 0, 0, 1, 0, 0, 1, 1, 0, NaN, 1, 0],
    [
      [0, 1, 2],
      [0, 1, 3],
      [0, 1, 9],
    ],
  );
  expect(read(writeModel(model, 'stl'), 'a.stl').positions.length).toBe(9);
});

test('an OFF may have comments anywhere and colours behind its faces', () => {
  const source = 'OFF # c\n# c\n4 2 0\n0 0 0\n1 0 0 # c\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2 255 0 0\n';
  expect(facesOf(read(source, 'a.off'))).toEqual([
    [0, 1, 2, 3],
    [0, 1, 2],
  ]);
  expect(codes(source, 'a.off')).toEqual(['attributes-ignored']);
});
