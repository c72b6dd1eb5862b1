// Joints of a file: read, written, opened by three.js; damaged ones are told of and left out.

import { type SkinnedMesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { describe, expect, test } from 'vitest';
import { IDENTITY } from '../../web/core/affine';
import { type Model, withPositions } from '../../web/core/model';
import type { Rig } from '../../web/core/rig';
import { readModel, writeModel } from '../../web/io/formats';
import { writeGltfMorphs } from '../../web/io/gltf-morphs';
import { gltf, type Piece } from './gltf-support';
import { bytes, makeModel, text } from './support';

/** A quarter turn about z, twice as large, at (1, 2, 0). */
const ELBOW = [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 1, 2, 0, 1];
const RIG: Rig = {
  // The child stands before its parent: files may have it so.
  joints: [
    { name: 'elbow', parent: 1, bind: ELBOW },
    { name: 'shoulder', parent: -1, bind: IDENTITY },
  ],
  influences: 4,
  indices: Uint16Array.from([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0]),
  weights: Float32Array.from([1, 0, 0, 0, 1, 0, 0, 0, 0.25, 0.75, 0, 0, 1, 0, 0, 0]),
};
const ARM: Model = {
  ...makeModel(
    [0, 0, 0, 1, 0, 0, 1, 2, 0, 1, 4, 0],
    [
      [0, 1, 2],
      [0, 2, 3],
    ],
  ),
  name: 'arm.ply',
  rig: RIG,
};

const again = (model: Model) => readModel(writeModel(model, 'glb'), 'arm.glb');

function expectRig(found: Rig | undefined, wanted: Rig): void {
  expect(found!.joints.map(({ name, parent }) => [name, parent])).toEqual(
    wanted.joints.map(({ name, parent }) => [name, parent]),
  );
  for (const [at, { bind }] of found!.joints.entries())
    for (const [k, x] of bind.entries()) expect(x).toBeCloseTo(wanted.joints[at]!.bind[k]!, 5);
  expect(found!.influences).toBe(wanted.influences);
  expect([...found!.indices]).toEqual([...wanted.indices]);
  expect([...found!.weights]).toEqual([...wanted.weights]);
}

async function skinnedMesh(file: Uint8Array): Promise<SkinnedMesh> {
  const { scene } = await new GLTFLoader().parseAsync(file.slice().buffer as ArrayBuffer, '');
  scene.updateMatrixWorld(true);
  const found: SkinnedMesh[] = [];
  scene.traverse((node) => {
    if ('isSkinnedMesh' in node) found.push(node as SkinnedMesh);
  });
  expect(found).toHaveLength(1);
  return found[0]!;
}

/** Where a vertex is shown, in the scene. */
function shown(mesh: SkinnedMesh, v: number): number[] {
  mesh.skeleton.update();
  return mesh.getVertexPosition(v, new Vector3()).applyMatrix4(mesh.matrixWorld).toArray();
}

const expectNear = (found: readonly number[], wanted: readonly number[]) => {
  for (const [k, x] of found.entries()) expect(x).toBeCloseTo(wanted[k]!, 5);
};

describe('a rigged model', () => {
  test('keeps its joints, their hierarchy and their weights from file to file', () => {
    const { model, notes } = again(ARM);
    expectRig(model.rig, RIG);
    expect(notes.map(({ code }) => code)).not.toContain('skin-unread');
    // Out of its own document, moved or not, and out of a new one.
    expectRig(again(model).model.rig, RIG);
    expectRig(
      again(
        withPositions(
          model,
          model.positions.map((x) => 2 * x),
        ),
      ).model.rig,
      RIG,
    );
    const { origin: _origin, ...loose } = model;
    expectRig(again(loose).model.rig, RIG);
  });

  test('has eight joints a vertex where it had', () => {
    const wide: Rig = {
      ...RIG,
      influences: 8,
      indices: Uint16Array.from({ length: 32 }, (_, at) => (at % 8 === 5 ? 1 : 0)),
      weights: Float32Array.from({ length: 32 }, (_, at) => (at % 8 === 5 ? 0.75 : at % 8 === 0 ? 0.25 : 0)),
    };
    expectRig(again({ ...ARM, rig: wide }).model.rig, wide);
  });

  test('is a skinned mesh whose rest is its shape and whose turned joint moves what is its', async () => {
    for (const file of [writeModel(ARM, 'glb'), writeGltfMorphs(ARM, [ARM], 'glb')]) {
      const mesh = await skinnedMesh(file);
      for (let v = 0; v < 4; v++) expectNear(shown(mesh, v), [...ARM.positions.subarray(3 * v, 3 * v + 3)]);
      // A half turn of the elbow about (1, 2, 0).
      const elbow = mesh.skeleton.bones.find(({ name }) => name === 'elbow')!;
      elbow.rotateZ(Math.PI);
      elbow.updateMatrixWorld(true);
      for (const v of [0, 1, 2]) expectNear(shown(mesh, v), [...ARM.positions.subarray(3 * v, 3 * v + 3)]);
      expectNear(shown(mesh, 3), [1, 0, 0]);
      // The elbow hangs from the shoulder: both turned, the hand has turned once about each.
      const shoulder = mesh.skeleton.bones.find(({ name }) => name === 'shoulder')!;
      shoulder.rotateZ(Math.PI);
      shoulder.updateMatrixWorld(true);
      expectNear(shown(mesh, 3), [-1, 0, 0]);
      expectNear(shown(mesh, 1), [-1, 0, 0]);
    }
  });

  test('in millimetres with z up, far from the origin, is at rest where it would be without joints', async () => {
    const far = withPositions(
      ARM,
      ARM.positions.map((x) => x + 4e6),
    );
    const joints = RIG.joints.map((joint) => ({
      ...joint,
      bind: joint.bind.map((x, at) => (at >= 12 && at < 15 ? x + 4e6 : x)),
    }));
    const model: Model = { ...far, rig: { ...RIG, joints }, unitMetres: 0.001, upAxis: 'z' };
    const mesh = await skinnedMesh(writeModel(model, 'glb'));
    for (let v = 0; v < 4; v++) {
      const [x, y, z] = [...model.positions.subarray(3 * v, 3 * v + 3)].map((c) => c / 1000);
      expectNear(shown(mesh, v), [x!, z!, -y!]);
    }
  });
});

const TRIANGLE: Piece = { values: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0), type: 'VEC3' };
const JOINTS: Piece = { values: Uint8Array.of(0, 1, 0, 0, 1, 9, 0, 0, 0, 0, 0, 0), type: 'VEC4' };
/** Not normalised to the last bit, and of the last vertex none. */
const WEIGHTS: Piece = { values: Float32Array.of(1, 3, 0, 0, 0.5, 0, 0, 0, 0, 0, 0, 0), type: 'VEC4' };

const rigged = (change: (json: ReturnType<typeof JSON.parse>) => void = () => undefined) => {
  const file = gltf([TRIANGLE, JOINTS, WEIGHTS], {
    scenes: [{ nodes: [0, 1] }],
    nodes: [
      { mesh: 0, skin: 0, translation: [9, 9, 9] },
      { name: 'hip', translation: [1, 0, 0], children: [2] },
      // Between two joints, itself none.
      { name: 'group', children: [3, 4] },
      { name: 'knee' },
      { name: 'hat', mesh: 1, translation: [0, 5, 0] },
    ],
    skins: [{ joints: [1, 3] }],
    meshes: [
      { primitives: [{ attributes: { POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2 } }] },
      { primitives: [{ attributes: { POSITION: 0 } }] },
    ],
  });
  const json = JSON.parse(text(file));
  change(json);
  return readModel(bytes(JSON.stringify(json)), 'leg.gltf');
};

describe('a file with joints', () => {
  test('weights make a whole, and what has no skin goes with its node', () => {
    const { rig } = rigged().model;
    expect(rig!.joints.map(({ name, parent }) => [name, parent])).toEqual([
      ['hip', -1],
      ['knee', 0],
      ['hat', 0],
    ]);
    const of = (v: number) => [...rig!.weights.subarray(4 * v, 4 * v + 4)];
    expect([0, 1, 2, 3].map(of)).toEqual([
      [0.25, 0.75, 0, 0],
      [1, 0, 0, 0],
      [1, 0, 0, 0],
      [1, 0, 0, 0],
    ]);
    expect([...rig!.indices.filter((_, at) => at % 4 === 0)]).toEqual([0, 1, 0, 2, 2, 2]);
    expect(rig!.joints[2]!.bind.slice(12, 15)).toEqual([1, 5, 0]);
  });

  test('joints are where they are while the model is at rest, whatever pose and place they are shown in', () => {
    // The knee is bent in the file; the mesh was bound 2 below its hip, all of it mirrored.
    const inverses = [
      ...[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1],
      ...[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 5, 0, 1],
    ];
    const { model } = rigged((json) => {
      json.nodes[1].scale = [-1, 1, 1];
      json.nodes[3].rotation = [0, 0, Math.SQRT1_2, Math.SQRT1_2];
      json.buffers.push({
        byteLength: 128,
        uri: `data:;base64,${Buffer.from(Float32Array.from(inverses).buffer).toString('base64')}`,
      });
      json.bufferViews.push({ buffer: 1, byteLength: 128 });
      json.accessors.push({ bufferView: 3, componentType: 5126, type: 'MAT4', count: 2 });
      json.skins[0].inverseBindMatrices = 3;
    });
    expect([...model.positions.subarray(0, 9)]).toEqual([1, 2, 0, 0, 2, 0, 1, 3, 0]);
    const [hip, knee] = model.rig!.joints.map(({ bind }) => bind);
    expectNear(hip!, [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1]);
    expectNear(knee!, [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, -3, 0, 1]);
    const { origin: _origin, ...loose } = model;
    expectRig(again(loose).model.rig, model.rig!);
  });

  test.each([
    ['alike share them', [0, 0, 0], ['hip', 'knee', 'hat'], [-1, 0, 0]],
    ['apart have their own of those', [0, 7, 0], ['hip', 'knee', 'hat', 'hip'], [-1, 0, 0, -1]],
  ])('skins that bind the same joints %s', (_, [x, y, z], names, parents) => {
    const { rig } = rigged((json) => {
      const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
      json.buffers.push({
        byteLength: 256,
        uri: `data:;base64,${Buffer.from(Float32Array.from([...IDENTITY, ...IDENTITY, ...IDENTITY, ...matrix]).buffer).toString('base64')}`,
      });
      json.bufferViews.push({ buffer: 1, byteLength: 128 }, { buffer: 1, byteOffset: 128, byteLength: 128 });
      for (const bufferView of [3, 4])
        json.accessors.push({ bufferView, componentType: 5126, type: 'MAT4', count: 2 });
      json.skins[0].inverseBindMatrices = 3;
      // In the other order: the knee places both meshes alike, so that only the hip may be bound elsewhere.
      json.skins.push({ joints: [3, 1], inverseBindMatrices: 4 });
      json.nodes.push({ mesh: 0, skin: 1 });
      json.scenes[0].nodes.push(5);
    }).model;
    expect(rig!.joints.map(({ name }) => name).sort()).toEqual([...names].sort());
    expect(rig!.joints.map(({ parent }) => parent).sort()).toEqual([...parents].sort());
  });

  test.each<[string, (json: ReturnType<typeof JSON.parse>) => void]>([
    ['weights of other vertices', (json) => (json.accessors[2].count = 2)],
    ['an accessor that is missing', (json) => (json.meshes[0].primitives[0].attributes.JOINTS_0 = 77)],
    ['an accessor that ends beyond its buffer', (json) => (json.bufferViews[2].byteOffset = 1e6)],
    ['a joint that the skin has not', (json) => (json.skins[0].joints = [1])],
    ['a joint that is no node', (json) => (json.skins[0].joints = [1, 88])],
    ['no joint', (json) => (json.skins[0].joints = [])],
    ['a skin that is missing', (json) => (json.nodes[0].skin = 5)],
    ['matrices that are none', (json) => (json.skins[0].inverseBindMatrices = 0)],
    ['a joint as small as nothing', (json) => (json.nodes[1].scale = [1e-60, 1e-60, 1e-60])],
    ['matrices that are missing', (json) => (json.skins[0].inverseBindMatrices = 99)],
  ])('%s: told of, and opened without', (_, change) => {
    const { model, notes } = rigged(change);
    expect(model.rig).toBeUndefined();
    expect(model.positions).toHaveLength(18);
    expect([...model.positions].every(Number.isFinite)).toBe(true);
    const note = notes.find(({ code }) => code === 'skin-unread');
    expect(note!.message).toMatch(/^The model opens without its joints\. .+\.$/);
  });
});
