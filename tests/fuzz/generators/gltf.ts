// glTF by its structure: documents with all that is read, changed in a few places, as JSON and as a container.

import { readModel, writeModel } from '../../../web/io';
import { type Generator, outcomeOf } from '../generator';
import { bytesOf, mutateBytes, mutateJson } from '../mutate';
import { checkModel } from './meshes';

const binary = new Uint8Array(400);
const floats = new Float32Array(binary.buffer);
floats.set([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1]);
floats.set([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1], 12);
floats.set([0, 0, 1, 0, 0, 1, 1, 1], 24);
floats.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1], 40);
binary.set([0, 1, 2, 2, 1, 3], 240);
binary.set([0, 1, 1, 0], 248);

const view = (byteOffset: number, byteLength: number) => ({ buffer: 0, byteOffset, byteLength });
const F32 = 5126;
const U8 = 5121;

const DOCUMENT = {
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0, 1] }],
  nodes: [
    { mesh: 0, name: 'a', children: [2], translation: [1, 2, 3], rotation: [0, 0, 0, 1], scale: [1, -1, 2] },
    { mesh: 1, skin: 0, matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 5, 5, 1] },
    { mesh: 0 },
  ],
  meshes: [
    {
      name: 'm',
      primitives: [
        {
          attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2, COLOR_0: 6, _SCALP: 5 },
          indices: 3,
          material: 0,
        },
        {
          attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2, COLOR_0: 6, _SCALP: 5 },
          mode: 5,
          extras: { name: 'x' },
        },
      ],
    },
    { primitives: [{ attributes: { POSITION: 4 }, mode: 6, targets: [{ POSITION: 0 }] }] },
  ],
  materials: [{ name: 'skin' }],
  skins: [{ joints: [2], inverseBindMatrices: 7 }],
  accessors: [
    { bufferView: 0, componentType: F32, count: 4, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 1] },
    { bufferView: 1, componentType: F32, count: 4, type: 'VEC3' },
    { bufferView: 2, componentType: F32, count: 4, type: 'VEC2' },
    { bufferView: 3, componentType: U8, count: 6, type: 'SCALAR' },
    {
      componentType: F32,
      count: 4,
      type: 'VEC3',
      sparse: { count: 2, indices: { bufferView: 3, componentType: U8 }, values: { bufferView: 0 } },
    },
    { bufferView: 4, componentType: U8, count: 4, type: 'SCALAR' },
    { bufferView: 1, componentType: F32, count: 4, type: 'VEC3', normalized: false },
    { bufferView: 5, componentType: F32, count: 1, type: 'MAT4' },
  ],
  bufferViews: [view(0, 48), view(48, 48), view(96, 32), view(240, 6), view(248, 4), view(160, 64)],
};

const TEXT = {
  ...DOCUMENT,
  buffers: [{ byteLength: 400, uri: `data:;base64,${Buffer.from(binary).toString('base64')}` }],
};
const CONTAINED = { ...DOCUMENT, buffers: [{ byteLength: 400 }] };

function container(json: unknown): Uint8Array {
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, 32)]);
  const out = Buffer.alloc(28 + padded.length + binary.length);
  out.write('glTF');
  out.writeUInt32LE(2, 4);
  out.writeUInt32LE(out.length, 8);
  out.writeUInt32LE(padded.length, 12);
  out.write('JSON', 16);
  padded.copy(out, 20);
  out.writeUInt32LE(binary.length, 20 + padded.length);
  out.write('BIN\0', 24 + padded.length);
  out.set(binary, 28 + padded.length);
  return new Uint8Array(out);
}

const gltf: Generator = {
  kind: 'glTF',
  run(random) {
    const contained = random.chance(0.3);
    const json = mutateJson(random, contained ? CONTAINED : TEXT, random.few(4)) ?? null;
    const made = contained ? container(json) : bytesOf(JSON.stringify(json));
    const file = random.chance(0.1) ? mutateBytes(random, made, 1) : made;
    return outcomeOf(async () => {
      const { model } = readModel(file, contained ? 'a.glb' : 'a.gltf');
      checkModel(model, file.length);
      const moved = { ...model, positions: model.positions.map((x) => x + 1) };
      for (const format of ['glb', 'ply', 'stl'] as const)
        for (const each of [model, moved])
          await outcomeOf(() => checkModel(readModel(writeModel(each, format), 'b').model, 1e9));
    });
  },
};
export default gltf;
