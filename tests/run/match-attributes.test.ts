// What a source has beside its shape is carried onto the skins.

import { beforeAll, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import { pear, plum } from '../kernel/balls';

const SHAPES = { pear: pear(), plum: plum() };
const { positions, faceVertices, faceOffsets, ends } = SHAPES.pear;
const count = positions.length / 3;
const x = (vertex: number) => positions[3 * vertex]!;
const y = (vertex: number) => positions[3 * vertex + 1]!;
/** Red rises with x, blue with y. */
const red = (at: number) => Math.round(127 + 100 * at);
const upper = Uint32Array.from(Array.from({ length: count }, (_, v) => v).filter((v) => y(v) > 0));

/** Texture by x and y on one half in z, the same beside it on the other: a seam where they meet. */
const half = (face: number) => {
  const middle = [0, 1, 2].reduce((sum, at) => sum + positions[3 * faceVertices[3 * face + at]! + 2]! / 3, 0);
  return middle > 0 ? 0 : 10;
};
const uvs = Float64Array.from(
  [...faceVertices].flatMap((v, corner) => [x(v) + half(Math.floor(corner / 3)), y(v)]),
);
const MODELS: Record<string, Model> = {
  pear: {
    name: 'pear',
    positions,
    faceVertices,
    faceOffsets,
    colors: Uint8Array.from(
      Array.from({ length: count }, (_, v) => [red(x(v)), 0, red(y(v) / 2), 255]).flat(),
    ),
    uvs,
    uvIndices: Uint32Array.from(faceVertices.keys()),
    vertexSets: { upper },
    groups: [
      { name: 'first', start: 0, end: 200, material: 'wool' },
      { name: 'rest', start: 200, end: faceOffsets.length - 1 },
    ],
  },
  plum: { name: 'plum', ...SHAPES.plum },
};

let skins: Readonly<Record<string, Model>>;
beforeAll(async () => {
  const runner = new Runner({ kernel: await loadKernel(), models: { load: async (name) => MODELS[name]! } });
  const markers = ends.map((vertex, at) => [vertex, SHAPES.plum.ends[at]!]);
  const models = { pear: { builtin: 'pear' }, plum: { builtin: 'plum' } };
  const step = { id: 'm', type: 'match', models: ['pear', 'plum'], markers, edgeLength: 0.3 };
  skins = (await runner.run(parseRecipe({ lissom: 1, models, steps: [step] }))).get('m')!.models!;
});

test('colours are mixed by place, and all skins share what was read off', () => {
  const { pear: skin, plum: other } = skins;
  expect(other!.colors).toBe(skin!.colors);
  expect(other!.faceVertices).toEqual(skin!.faceVertices);
  for (let v = 0; v < skin!.positions.length / 3; v++) {
    expect(Math.abs(skin!.colors![4 * v]! - red(skin!.positions[3 * v]!))).toBeLessThan(6);
    expect(Math.abs(skin!.colors![4 * v + 2]! - red(skin!.positions[3 * v + 1]! / 2))).toBeLessThan(6);
    expect(skin!.colors![4 * v + 3]).toBe(255);
  }
});

test('sets of vertices keep to their places', () => {
  const { positions: places, vertexSets } = skins.pear!;
  expect(vertexSets!.upper!.length).toBeGreaterThan(50);
  for (const v of vertexSets!.upper!) expect(places[3 * v + 1]).toBeGreaterThan(-0.2);
});

test('no triangle is torn across a seam of the texture', () => {
  const { faceVertices: corners, positions: places, uvs: found, uvIndices } = skins.pear!;
  let off = 0;
  for (let corner = 0; corner < corners.length; corner++) {
    const uv = uvIndices![corner]!;
    const u = found![2 * uv]!;
    const place = places[3 * corners[corner]!]!;
    if (Math.min(Math.abs(u - place), Math.abs(u - place - 10)) > 0.1) off++;
  }
  expect(off).toBe(0);
  const halves = (face: number) =>
    new Set([0, 1, 2].map((at) => (found![2 * uvIndices![3 * face + at]!]! > 5 ? 'far' : 'near'))).size;
  const torn = Array.from({ length: corners.length / 3 }, (_, face) => halves(face)).filter((n) => n > 1);
  expect(torn).toEqual([]);
});

test('groups are runs of triangles again', () => {
  const { groups, faceOffsets: offsets } = skins.pear!;
  expect(groups!.map(({ name, material }) => [name, material])).toEqual([
    ['first', 'wool'],
    ['rest', undefined],
  ]);
  expect(groups![0]!.start).toBe(0);
  expect(groups![1]!.end).toBe(offsets.length - 1);
  expect(groups![0]!.end).toBe(groups![1]!.start);
  expect(skins.plum!.groups).toBe(groups);
});
