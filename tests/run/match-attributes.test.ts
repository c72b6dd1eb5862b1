// What a source has beside its shape is carried onto the skins.

import { beforeAll, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import { carriedMorphs } from '../../web/run/steps/match/morphs';
import { pear, plum } from '../kernel/balls';

const SHAPES = { pear: pear(), plum: plum() };
const { positions, faceVertices, faceOffsets, ends } = SHAPES.pear;
const count = positions.length / 3;
const x = (vertex: number) => positions[3 * vertex]!;
const y = (vertex: number) => positions[3 * vertex + 1]!;
/** Red rises with x, blue with y. */
const red = (at: number) => Math.round(127 + 100 * at);
/** Of a morph that makes it larger about its middle. */
const SWELL = 0.5;
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
    morphs: [{ name: 'swell', offsets: Float32Array.from(positions, (value) => SWELL * value) }],
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

test('morphs are read off for the first skin where it lies on its model', () => {
  const skin = skins.pear!;
  const [swell] = skin.morphs!;
  expect(swell!.name).toBe('swell');
  let [off, size] = [0, 0];
  for (const [at, offset] of swell!.offsets.entries()) {
    off += Math.abs(offset - SWELL * skin.positions[at]!);
    size += Math.abs(SWELL * skin.positions[at]!);
  }
  expect(off / size).toBeLessThan(0.02);
});

test('carried to another shape they go the way that they went: what swells one swells the other', () => {
  const other = skins.plum!;
  const { offsets } = other.morphs![0]!;
  let [outward, sizes] = [0, 0];
  const rows = other.positions.length / 3;
  for (let v = 0; v < rows; v++) {
    const p = other.positions.subarray(3 * v, 3 * v + 3);
    const o = offsets.subarray(3 * v, 3 * v + 3);
    const along = [0, 1, 2].reduce((sum, axis) => sum + p[axis]! * o[axis]!, 0);
    if (along > 0) outward++;
    sizes += Math.hypot(...o) / Math.hypot(...p) / SWELL / rows;
  }
  expect(outward).toBe(rows);
  // Across the surface a way grows with the root of the area, not with what is below it: by 0.88 where the plum is 1.4 times as wide.
  expect(sizes).toBeGreaterThan(0.88 / 1.4);
  expect(sizes).toBeLessThan(1.4 / 0.88);
});

test('carried to a skin that is turned, moved and scaled they are turned and scaled', () => {
  const { positions: from, faceVertices: triangles } = skins.pear!;
  const turn = (x: number, y: number, z: number) => [-3 * y, 3 * x, 3 * z];
  const to = new Float64Array(from.length);
  const offsets = Float32Array.from(from, (value, at) => Math.sin(7 * value + at));
  const wanted = new Float32Array(from.length);
  for (let at = 0; at < from.length; at += 3) {
    to.set(
      turn(from[at]!, from[at + 1]!, from[at + 2]!).map((value) => value + 5),
      at,
    );
    wanted.set(turn(offsets[at]!, offsets[at + 1]!, offsets[at + 2]!), at);
  }
  const [carried] = carriedMorphs([{ name: 'any', offsets }], triangles, from, to);
  const most = carried!.offsets.reduce(
    (worst, value, at) => Math.max(worst, Math.abs(value - wanted[at]!)),
    0,
  );
  expect(most).toBeLessThan(1e-5);
  expect(carriedMorphs([], triangles, from, to)).toEqual([]);
});

test('a blend has the morphs of its skins by their weights', async () => {
  const runner = new Runner({ kernel: await loadKernel(), models: { load: async (name) => MODELS[name]! } });
  const markers = ends.map((vertex, at) => [vertex, SHAPES.plum.ends[at]!]);
  const models = { pear: { builtin: 'pear' }, plum: { builtin: 'plum' } };
  const match = { id: 'm', type: 'match', models: ['pear', 'plum'], markers, edgeLength: 0.3 };
  const blend = { id: 'b', type: 'blend', match: 'm', weights: { pear: 0.25, plum: 0.75 } };
  const results = await runner.run(parseRecipe({ lissom: 1, models, steps: [match, blend] }));
  const { pear: a, plum: b } = results.get('m')!.models!;
  const [swell] = results.get('b')!.model.morphs!;
  for (const at of [0, 10, 50, 100])
    expect(swell!.offsets[at]).toBeCloseTo(
      0.25 * a!.morphs![0]!.offsets[at]! + 0.75 * b!.morphs![0]!.offsets[at]!,
      5,
    );
});
