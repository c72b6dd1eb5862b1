// Joints through a match: read off for the first skin, brought to where they belong in the other bodies, and blended.

import { type SkinnedMesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { beforeAll, describe, expect, test } from 'vitest';
import { type Affine, IDENTITY, multiply } from '../../web/core/affine';
import type { Model } from '../../web/core/model';
import type { Rig } from '../../web/core/rig';
import { readModel, writeModel } from '../../web/io/formats';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { carriedRig } from '../../web/run/carried-rig';
import { Runner } from '../../web/run/evaluate';
import { pear, plum } from '../kernel/balls';

const at = (x: number, y: number, z: number): Affine => [...IDENTITY.slice(0, 12), x, y, z, 1];

/** Weights that go over from the joint below to the one above; the other two move nothing. */
function rigOf(positions: Float64Array): Rig {
  const count = positions.length / 3;
  const weights = new Float32Array(4 * count);
  for (let v = 0; v < count; v++) {
    const above = Math.min(1, Math.max(0, 0.5 + 0.5 * positions[3 * v + 1]!));
    weights.set([1 - above, above], 4 * v);
  }
  return {
    joints: [
      { name: 'below', parent: 2, bind: at(0, -0.5, 0) },
      {
        name: 'above',
        parent: 0,
        bind: [...multiply(at(0, 0.5, 0), [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])],
      },
      { name: 'root', parent: -1, bind: at(0, 0, 0) },
      { name: 'tip', parent: 1, bind: at(0, 1, 0) },
    ],
    influences: 4,
    indices: Uint16Array.from({ length: 4 * count }, (_, k) => (k % 4 === 1 ? 1 : 0)),
    weights,
  };
}

const expectAffine = (found: Affine, wanted: Affine, digits: number) => {
  for (const [k, x] of found.entries()) expect(x).toBeCloseTo(wanted[k]!, digits);
};

/** A third of a turn about (1, 1, 1), three times as large, elsewhere. */
const MOVED: Affine = [0, 3, 0, 0, 0, 0, 3, 0, 3, 0, 0, 0, 5, -7, 11, 1];

const image = (matrix: Affine, points: Float64Array) =>
  Float64Array.from(points, (_, k) => {
    const first = k - (k % 3);
    const row = k % 3;
    return [0, 1, 2].reduce((sum, c) => sum + matrix[4 * c + row]! * points[first + c]!, matrix[12 + row]!);
  });

describe('joints carried to another skin', () => {
  const { positions, faceVertices: triangles } = pear();

  test('go by the similarity where one skin is the other turned, moved and scaled', () => {
    const rig = rigOf(positions);
    const carried = carriedRig(rig, triangles, positions, image(MOVED, positions));
    for (const [joint, { bind, name }] of carried.joints.entries()) {
      expectAffine(bind, multiply(MOVED, rig.joints[joint]!.bind), 9);
      expect(name).toBe(rig.joints[joint]!.name);
    }
    expect(carried.weights).toBe(rig.weights);
  });

  test('each goes with what it moves, and what moves nothing with the one it hangs from', () => {
    const rig: Rig = { ...rigOf(positions) };
    for (let v = 0; 3 * v < positions.length; v++)
      rig.weights.set(positions[3 * v + 1]! > 0 ? [0, 1] : [1, 0], 4 * v);
    // What is above moves up as it is, what is below stays.
    const to = positions.map((x, k) => (k % 3 === 1 && x > 0 ? x + 2 : x));
    const binds = carriedRig(rig, triangles, positions, to).joints.map(({ bind }) => bind);
    expectAffine(binds[0]!, rig.joints[0]!.bind, 9);
    expectAffine(binds[1]!, multiply(at(0, 2, 0), rig.joints[1]!.bind), 9);
    expectAffine(binds[3]!, multiply(at(0, 2, 0), rig.joints[3]!.bind), 9);
  });

  test('a joint of a single vertex has no turn of its own', () => {
    const rig = rigOf(positions);
    rig.indices[0] = 3;
    rig.weights.set([1, 0], 0);
    const { joints } = carriedRig(rig, triangles, positions, image(MOVED, positions));
    expectAffine(joints[3]!.bind, multiply(MOVED, rig.joints[3]!.bind), 9);
  });
});

describe('a match', () => {
  const SHAPES = { pear: pear(), plum: plum() };
  const { ends: _ends, ...source } = SHAPES.pear;
  const MODELS: Record<string, Model> = {
    // As it comes from a file.
    pear: readModel(writeModel({ name: 'pear', ...source, rig: rigOf(source.positions) }, 'glb'), 'pear.glb')
      .model,
    plum: { name: 'plum', ...SHAPES.plum },
  };
  let skins: Readonly<Record<string, Model>>;
  let blend: Model;
  beforeAll(async () => {
    const runner = new Runner({
      kernel: await loadKernel(),
      models: { load: async (name) => MODELS[name]! },
    });
    const markers = SHAPES.pear.ends.map((vertex, k) => [vertex, SHAPES.plum.ends[k]!]);
    const models = { pear: { builtin: 'pear' }, plum: { builtin: 'plum' } };
    const step = { id: 'm', type: 'match', models: ['pear', 'plum'], markers, edgeLength: 0.3 };
    const mix = { id: 'b', type: 'blend', match: 'm', weights: { plum: 1 } };
    const results = await runner.run(parseRecipe({ lissom: 1, models, steps: [step, mix] }));
    skins = results.get('m')!.models!;
    blend = results.get('b')!.model;
  });

  test('mixes weights by place; they sum to one, on all skins alike', () => {
    const { rig, positions } = skins.pear!;
    expect(skins.plum!.rig!.weights).toBe(rig!.weights);
    expect(rig!.weights).toHaveLength((4 * positions.length) / 3);
    for (let v = 0; 3 * v < positions.length; v++) {
      const of = [0, 1, 2, 3].map((k) => rig!.weights[4 * v + k]!);
      expect(of.reduce((sum, x) => sum + x)).toBeCloseTo(1, 6);
      const above = of.reduce((sum, x, k) => (rig!.indices[4 * v + k] === 1 ? sum + x : sum), 0);
      const wanted = Math.min(1, Math.max(0, 0.5 + 0.5 * positions[3 * v + 1]!));
      expect(Math.abs(above - wanted)).toBeLessThan(0.05);
    }
  });

  test('leaves joints of the first skin where they were, and takes those of the other into it', () => {
    expect(skins.pear!.rig!.joints).toBe(MODELS.pear!.rig!.joints);
    const heights = (model: Model) => model.rig!.joints.map(({ bind }) => bind[13]!);
    const [below, above, , tip] = heights(skins.plum!);
    expect(below!).toBeLessThan(above!);
    expect(above!).toBeLessThan(tip!);
  });

  test('a blend has them where they are on a skin of its shape', () => {
    for (const [joint, { bind }] of blend.rig!.joints.entries())
      expectAffine(bind, skins.plum!.rig!.joints[joint]!.bind, 6);
  });

  test('its skins open as skinned meshes: at rest their shape, a turned joint takes along what is its', async () => {
    for (const skin of [skins.pear!, skins.plum!]) {
      const { scene } = await new GLTFLoader().parseAsync(
        writeModel(skin, 'glb').slice().buffer as ArrayBuffer,
        '',
      );
      scene.updateMatrixWorld(true);
      let mesh!: SkinnedMesh;
      scene.traverse((node) => {
        if ('isSkinnedMesh' in node) mesh = node as SkinnedMesh;
      });
      const shown = (v: number) => mesh.getVertexPosition(v, new Vector3()).toArray();
      const rest = (v: number) => [...skin.positions.subarray(3 * v, 3 * v + 3)];
      const above = mesh.skeleton.bones.find(({ name }) => name === 'above')!;
      mesh.skeleton.update();
      const count = skin.positions.length / 3;
      for (let v = 0; v < count; v++) expectAffine(shown(v), rest(v), 5);
      above.position.x += 2;
      scene.updateMatrixWorld(true);
      mesh.skeleton.update();
      // The joint below carries it, and may be turned and scaled: how far two went is as its share of the weights.
      const way = new Vector3(2, 0, 0)
        .transformDirection(above.parent!.matrixWorld)
        .multiplyScalar(2 * above.parent!.getWorldScale(new Vector3()).x);
      const { indices, weights } = skin.rig!;
      for (let v = 0; v < count; v++) {
        const share = [0, 1, 2, 3].reduce(
          (sum, k) => sum + (indices[4 * v + k] === 1 ? weights[4 * v + k]! : 0),
          0,
        );
        const wanted = way.toArray().map((x, k) => rest(v)[k]! + share * x);
        expectAffine(shown(v), wanted, 5);
      }
    }
  });
});
