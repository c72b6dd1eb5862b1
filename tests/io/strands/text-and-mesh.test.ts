import { describe, expect, test } from 'vitest';
import { type Model, vertexCount } from '../../../web/core/model';
import { readModel, readStrands, type StrandWriteOptions, writeStrands } from '../../../web/io';
import { bytes, codeOf, facesOf, text } from '../support';
import { greatestGap, HEAD, inCentimetres, MILLIMETRES, makeGroom } from './support';

const GROOM = makeGroom(30, (s) => 2 + (s % 12));
const HEAD_CM = Array.from(HEAD.positions, (c) => 0.1 * c);
const write = (format: 'obj' | 'ply' | 'glb', options: Partial<StrandWriteOptions> = {}, groom = GROOM) =>
  writeStrands(groom, format, { ...MILLIMETRES, ...options });

describe('OBJ', () => {
  test('strands come back within half a unit of single precision, and the head with them', () => {
    const { strands, head } = readStrands(write('obj'), 'wavy.obj');
    expect(strands.offsets).toEqual(GROOM.strands.offsets);
    expect(greatestGap(strands.points, inCentimetres(GROOM))).toBeLessThan(2e-6);
    expect(greatestGap(head!.positions, HEAD_CM)).toBeLessThan(1e-12);
    expect(facesOf(head!)).toEqual(facesOf(HEAD));
    expect([head!.unitMetres, head!.upAxis]).toEqual([0.01, 'y']);
  });

  test('what was read and is written again does not change', () => {
    const once = readStrands(write('obj'), 'wavy.obj');
    const again = writeStrands(once, 'obj', { centimetresPerUnit: 1 });
    const twice = readStrands(again, 'wavy.obj');
    expect(text(again)).toBe(text(writeStrands(twice, 'obj', { centimetresPerUnit: 1 })));
    expect(text(again).match(/^o .*$/gm)).toEqual(['o Strands']);
    expect(twice.strands).toEqual(once.strands);
    expect(twice.head!.positions).toEqual(once.head!.positions);
  });

  test('segments that follow each other are one strand, and vertices may be counted backwards', () => {
    const file = bytes('v 0 0 0\nv 0 1 0\nv 0 2 0\nl 1 2\nl 2 3\nv 5 0 0\nv 5 1 0\nl -2/1 -1\n');
    const { strands, head } = readStrands(file, 'a.obj');
    expect([...strands.offsets]).toEqual([0, 3, 5]);
    expect([...strands.points]).toEqual([0, 0, 0, 0, 1, 0, 0, 2, 0, 5, 0, 0, 5, 1, 0]);
    expect(head).toBeUndefined();
  });

  test('far from the origin, points keep their digits beside an origin', () => {
    const file = bytes('v 4000000 0 0.125\nv 4000000.25 1 0\nl 1 2\n');
    const { strands } = readStrands(file, 'a.obj');
    const back = [...strands.points].map((c, i) => c + strands.origin[i % 3]!);
    expect(back).toEqual([4000000, 0, 0.125, 4000000.25, 1, 0]);
  });

  test('a mesh without lines, a missing vertex and other formats are refused by name', () => {
    const failing = (content: string, name = 'a.obj') => codeOf(() => readStrands(bytes(content), name));
    expect(failing('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n')).toBe('no-strands');
    expect(failing('v 0 0 0\nl 1 2\n')).toBe('file-damaged');
    expect(failing('v 0 0 0\nl 1 x\n')).toBe('file-damaged');
    expect(failing('#usda 1.0\n', 'a.usda')).toBe('format-unsupported');
    expect(failing('', 'a.hair')).toBe('file-empty');
  });
});

describe('PLY', () => {
  test('is read back with the head’s faces, the strands’ numbers and diameters', () => {
    const { model } = readModel(write('ply'), 'wavy.ply');
    expect(facesOf(model)).toEqual(facesOf(HEAD));
    expect(greatestGap(model.positions.subarray(0, 24), Float32Array.from(HEAD_CM))).toBe(0);
    expect(Float32Array.from(model.positions.subarray(24))).toEqual(inCentimetres(GROOM));
    const columns = (model.origin!.extra as { vertexColumns: { name: string; values: Float64Array }[] })
      .vertexColumns;
    const strand = columns.find((c) => c.name === 'strand')!.values;
    expect([...strand.subarray(0, 8)]).toEqual(new Array(8).fill(-1));
    const { offsets } = GROOM.strands;
    for (let s = 0; s < 30; s++)
      for (let p = offsets[s]!; p < offsets[s + 1]!; p++) expect(strand[8 + p]).toBe(s);
    expect(columns.find((c) => c.name === 'width')!.values[8]).toBeCloseTo(0.007, 8);
    expect([model.unitMetres, model.upAxis]).toEqual([0.01, 'y']);
  });

  test('every segment is an edge', () => {
    const file = write('ply', { withHead: false });
    const segments = GROOM.strands.points.length / 3 - 30;
    expect(text(file.subarray(0, 400))).toContain(`element edge ${segments}\n`);
    const view = new DataView(file.buffer, file.byteOffset + file.length - 8 * segments);
    expect([view.getInt32(0, true), view.getInt32(4, true)]).toEqual([0, 1]);
    const last = GROOM.strands.points.length / 3 - 1;
    const at = 8 * (segments - 1);
    expect([view.getInt32(at, true), view.getInt32(at + 4, true)]).toEqual([last - 1, last]);
  });
});

describe('GLB', () => {
  const json = (file: Uint8Array) =>
    JSON.parse(text(file.subarray(20, 20 + new DataView(file.buffer).getUint32(12, true))));
  const full = makeGroom(3000, () => 20);

  test('holds the head and the finest cards in one space', () => {
    const { model, notes } = readModel(write('glb'), 'wavy.glb');
    expect(notes).toEqual([]);
    expect(model.groups!.map(({ name }) => name)).toEqual(['Head', 'Hair_LOD0']);
    const head = boxOf(model, 0, HEAD.uvs ? vertexCountOfHead(model) : 0);
    expect(greatestGap([...head.min, ...head.max], [-0.08, -0.12, -0.1, 0.08, 0.12, 0.1])).toBeLessThan(1e-7);
    const hair = boxOf(model, vertexCountOfHead(model), vertexCount(model));
    const strands = inCentimetres(GROOM);
    for (let k = 0; k < 3; k++) {
      const along = strands.filter((_, i) => i % 3 === k);
      expect(hair.min[k]!).toBeGreaterThan(0.01 * Math.min(...along) - 0.05);
      expect(hair.max[k]!).toBeLessThan(0.01 * Math.max(...along) + 0.05);
    }
  });

  test('has three levels of detail, each much coarser, the coarser out of the scene', () => {
    const { nodes, scenes, meshes, accessors, extensionsUsed } = json(write('glb', {}, full));
    expect(extensionsUsed).toEqual(['MSFT_lod']);
    expect(nodes.map((n: { name: string }) => n.name)).toEqual([
      'Head',
      'Hair_LOD0',
      'Hair_LOD1',
      'Hair_LOD2',
    ]);
    expect(nodes[1].extensions.MSFT_lod.ids).toEqual([2, 3]);
    expect(scenes[0].nodes).toEqual([0, 1]);
    const corners = [1, 2, 3].map((m) => accessors[meshes[m].primitives[0].indices].count);
    expect(corners[1]).toBeLessThan(corners[0] / 2);
    expect(corners[2]).toBeLessThan(corners[1] / 2);
  });

  test('cards run from v = 0 at the root to v = 1 at the tip, u across, with tangents and colours', () => {
    const { meshes } = json(write('glb'));
    const attributes = Object.keys(meshes[1].primitives[0].attributes);
    expect(attributes).toEqual(['POSITION', 'NORMAL', 'TANGENT', 'TEXCOORD_0', 'COLOR_0']);
    const { model } = readModel(write('glb', { withHead: false }), 'wavy.glb');
    const us = new Set<number>();
    for (let i = 0; i < model.uvs!.length; i += 2) us.add(model.uvs![i]!);
    expect([...us].sort()).toEqual([0, 1]);
    expect([model.uvs![1], model.uvs![2 * 24 + 1]]).toEqual([1, 0]);
    expect(model.colors![0]).toBeGreaterThan(model.colors![2]!);
  });

  test('normals, tangents and triangles agree, and all are of length one', () => {
    const file = write('glb', { withHead: false }, full);
    const { meshes, accessors, bufferViews } = json(file);
    const start = 28 + new DataView(file.buffer).getUint32(12, true);
    const floats = (accessor: number, size: number) => {
      const { byteOffset } = bufferViews[accessors[accessor].bufferView];
      const length = size * accessors[accessor].count;
      return new Float32Array(file.slice(start + byteOffset, start + byteOffset + 4 * length).buffer);
    };
    const { POSITION, NORMAL, TANGENT } = meshes[0].primitives[0].attributes;
    const [p, n, t] = [floats(POSITION, 3), floats(NORMAL, 3), floats(TANGENT, 4)];
    for (let v = 0; v < n.length / 3; v += 2) {
      const normal = [...n.subarray(3 * v, 3 * v + 3)];
      const side = [...t.subarray(4 * v, 4 * v + 3)];
      const across = [0, 1, 2].map((k) => p[3 * v + 3 + k]! - p[3 * v + k]!);
      const dot = (a: number[], b: number[]) => a.reduce((sum, c, k) => sum + c * b[k]!, 0);
      expect(dot(normal, normal)).toBeCloseTo(1, 5);
      expect(dot(side, side)).toBeCloseTo(1, 5);
      expect(dot(normal, side)).toBeCloseTo(0, 5);
      expect(dot(across, side)).toBeCloseTo(Math.sqrt(dot(across, across)), 4);
    }
  });
});

const vertexCountOfHead = ({ faceVertices, groups }: Model): number =>
  faceVertices
    .subarray(3 * groups![0]!.start, 3 * groups![0]!.end)
    .reduce((most, v) => Math.max(most, v + 1), 0);

function boxOf({ positions }: Model, from: number, to: number) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 3 * from; i < 3 * to; i++) {
    min[i % 3] = Math.min(min[i % 3]!, positions[i]!);
    max[i % 3] = Math.max(max[i % 3]!, positions[i]!);
  }
  return { min, max };
}
