// Models of one connectivity as morph targets, read back by three.js.

import type { Mesh } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { describe, expect, test } from 'vitest';
import { type Model, withPositions } from '../../web/core/model';
import { readModel, writeModel } from '../../web/io/formats';
import { writeGltfMorphs } from '../../web/io/gltf-morphs';
import { writeModelArchive } from '../../web/io/model-archive';
import { readZip } from '../../web/io/zip';
import { makeModel } from './support';

const FIRST: Model = {
  ...makeModel(
    [0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 1, 3],
    [
      [0, 1, 4],
      [1, 2, 4],
      [2, 3, 4],
    ],
  ),
  name: 'first.ply',
};
const shaped = (name: string, change: (x: number, at: number) => number): Model => ({
  ...withPositions(FIRST, FIRST.positions.map(change)),
  name,
});
const TALL = shaped('tall.ply', (x, at) => (at % 3 === 2 ? 2 * x + 1 : x));
const WIDE = shaped('wide', (x, at) => (at % 3 === 0 ? 3 * x : x));

async function meshOf(file: Uint8Array): Promise<Mesh> {
  const { scene } = await new GLTFLoader().parseAsync(file.slice().buffer as ArrayBuffer, '');
  const found: Mesh[] = [];
  scene.traverse((node) => {
    if ('isMesh' in node) found.push(node as Mesh);
  });
  expect(found).toHaveLength(1);
  return found[0]!;
}

describe('morph targets', () => {
  test('each is called after its model, and leads to it', async () => {
    const mesh = await meshOf(writeGltfMorphs(FIRST, [TALL, WIDE], 'glb'));
    expect(mesh.morphTargetDictionary).toEqual({ tall: 0, wide: 1 });
    expect(mesh.morphTargetInfluences).toEqual([0, 0]);
    const rest = mesh.geometry.attributes.position!;
    for (const [at, model] of [TALL, WIDE].entries()) {
      const moved = mesh.geometry.morphAttributes.position![at]!;
      expect(moved.count).toBe(rest.count);
      const shown = Array.from({ length: rest.count }, (_, v) =>
        [0, 1, 2].map((k) => rest.getComponent(v, k) + moved.getComponent(v, k)),
      );
      expect(shown.flat()).toEqual([...model.positions]);
      expect(mesh.geometry.morphAttributes.normal![at]!.count).toBe(rest.count);
    }
  });

  test('far from the origin they are as exact as near it', async () => {
    const far = (model: Model) =>
      withPositions(
        model,
        model.positions.map((x) => x + 1e6),
      );
    const mesh = await meshOf(writeGltfMorphs(far(FIRST), [far(TALL)], 'glb'));
    const moved = mesh.geometry.morphAttributes.position![0]!;
    const [v, z] = [4, 2];
    expect(moved.getComponent(v, z)).toBeCloseTo(TALL.positions[14]! - FIRST.positions[14]!, 5);
  });

  test('with none it is a model like any other', async () => {
    const mesh = await meshOf(writeGltfMorphs(FIRST, [], 'glb'));
    expect(mesh.geometry.attributes.position!.count).toBe(5);
  });
});

describe('an archive', () => {
  test.each(['obj', 'ply'] as const)('%s: a file for each model, with the same faces', (format) => {
    const files = readZip(writeModelArchive([FIRST, TALL, { ...WIDE, name: 'tall' }], format), {
      bytes: 1e6,
      files: 9,
    });
    expect([...files.keys()]).toEqual([`first.${format}`, `tall.${format}`, `tall 2.${format}`]);
    const models = [...files].map(([name, bytes]) => readModel(bytes, name).model);
    for (const { faceVertices } of models) expect(faceVertices).toEqual(FIRST.faceVertices);
    expect([...models[2]!.positions]).toEqual([...WIDE.positions]);
  });
});

describe('morphs of a model', () => {
  const brow = {
    name: 'brow.L',
    offsets: Float32Array.from({ length: 15 }, (_, at) => (at === 14 ? 0.5 : 0)),
  };
  const FACE: Model = { ...FIRST, morphs: [brow] };

  test('are written with it and read again, by their names', () => {
    for (const format of ['glb', 'gltf'] as const) {
      const { model, notes } = readModel(writeModel(FACE, format), `face.${format}`);
      expect(model.morphs!.map(({ name }) => name)).toEqual(['brow.L']);
      expect([...model.morphs![0]!.offsets]).toEqual([...brow.offsets]);
      expect(notes.map(({ code }) => code)).not.toContain('morph-targets');
    }
  });

  test('go out as sliders beside the models of a match', async () => {
    const mesh = await meshOf(writeGltfMorphs(FACE, [TALL], 'glb'));
    expect(mesh.morphTargetDictionary).toEqual({ tall: 0, 'brow.L': 1 });
    const moved = mesh.geometry.morphAttributes.position![1]!;
    expect(moved.getZ(4)).toBe(0.5);
    expect(moved.getX(4)).toBe(0);
  });

  test('are turned and scaled as their node is, and not moved', () => {
    const file = JSON.parse(new TextDecoder().decode(writeModel(FACE, 'gltf')));
    // A quarter turn about x, twice as large, somewhere else.
    const node = { translation: [7, 8, 9], rotation: [Math.SQRT1_2, 0, 0, Math.SQRT1_2], scale: [2, 2, 2] };
    Object.assign(file.nodes[0], node);
    const { model } = readModel(new TextEncoder().encode(JSON.stringify(file)), 'face.gltf');
    const [x, y, z] = model.morphs![0]!.offsets.subarray(12);
    expect(x).toBeCloseTo(0, 6);
    expect(y).toBeCloseTo(-1, 6);
    expect(z).toBeCloseTo(0, 6);
  });

  test('that are of other vertices, or move none, are told of and left out', () => {
    const file = JSON.parse(new TextDecoder().decode(writeModel(FACE, 'gltf')));
    for (const targets of [[{}], [{ POSITION: file.meshes[0].primitives[0].indices }]]) {
      file.meshes[0].primitives[0].targets = targets;
      const { model, notes } = readModel(new TextEncoder().encode(JSON.stringify(file)), 'face.gltf');
      expect(model.morphs).toBeUndefined();
      expect(notes.map(({ code }) => code)).toContain('morph-targets');
    }
  });

  test('of one name are told apart, of none are numbered', () => {
    const twice = { ...FACE, morphs: [brow, brow] };
    const file = JSON.parse(new TextDecoder().decode(writeModel(twice, 'gltf')));
    const namesOf = () =>
      readModel(new TextEncoder().encode(JSON.stringify(file)), 'face.gltf').model.morphs!.map(
        ({ name }) => name,
      );
    expect(namesOf()).toEqual(['brow.L', 'brow.L 2']);
    file.meshes[0].extras = { targetNames: 5 };
    expect(namesOf()).toEqual(['morph 1', 'morph 2']);
  });
});
