// Curves as a skin, on the real kernel: read by the loader of three.js, it stands as the kernel's poses do.

import { AnimationMixer, Bone, type Object3D, type SkinnedMesh, Vector3 } from 'three';
import { type GLTF, GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { beforeAll, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { JOINT, type Skin } from '../../web/core/skin';
import { readModel } from '../../web/io/formats';
import { writeSkinnedGltf } from '../../web/io/gltf-skin';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import type { Recipe } from '../../web/recipe/recipe';
import type { CurvePosture } from '../../web/recipe/steps/curves';
import { Runner } from '../../web/run/evaluate';
import { dome, tube } from '../kernel/tubes';
import { recipeOfStep } from './curves-recipe';

type Point = [number, number, number];

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const LENGTH = 2;
const MODEL: Model = {
  name: 'm',
  ...tube(48, 24, (s, t) => dome(s, t).map((x, k) => (k === 1 ? x : 0.3 * x)) as unknown as Point),
};
const heights = (from: number, to: number, count: number) =>
  Array.from({ length: count }, (_, k) => from + ((to - from) * k) / (count - 1));
const LOWER = heights(0, 1.1, 4).map((y): Point => [0, y, 0]);
const UPPER = heights(1.1, 1.95, 4).map((y): Point => [0, y, 0]);
/** Turned about z as a whole, by degrees, about its first point. */
const bow = (points: readonly Point[], degrees: number): Point[] => {
  const out: Point[] = [points[0]!];
  for (let k = 1; k < points.length; k++) {
    const angle = ((degrees * k) / (points.length - 1)) * (Math.PI / 180);
    const length = points[k]![1] - points[k - 1]![1];
    const [x, y, z] = out[k - 1]!;
    out.push([x + length * Math.sin(angle), y + length * Math.cos(angle), z]);
  }
  return out;
};
const STRETCHED = LOWER.map(([x, y, z]): Point => [x, 1.3 * y, z]);

const POSES = [
  { name: 'rest', time: 0, curves: [] },
  {
    name: 'bowed',
    time: 1,
    curves: [
      { id: 'lower', posed: bow(LOWER, 40) },
      { id: 'upper', posed: bow(UPPER, 60) },
    ],
  },
  {
    name: 'stretched',
    time: 2.5,
    curves: [
      { id: 'lower', posed: STRETCHED, scale: LOWER.map((_, k): [number, number] => [1 + 0.1 * k, 1]) },
      { id: 'upper', twist: [0, 20, 40, 60] },
    ],
  },
];

/** @param posed  the posture that the step itself has */
const recipeOf = (posed: object = {}, more: object = {}): Recipe =>
  recipeOfStep({
    curves: [
      { id: 'lower', kind: 'skeleton', rest: LOWER, anchor: 'start', ...posed },
      { id: 'upper', kind: 'skeleton', rest: UPPER },
    ],
    links: [{ child: 'upper', parent: 'lower', at: 1 }],
    poses: POSES,
    ...more,
  });

const runnerFor = (model: Model) => new Runner({ kernel, models: { load: async () => model } });

async function skinned(recipe: Recipe, model = MODEL): Promise<{ skin: Skin; file: Uint8Array; gltf: GLTF }> {
  const skin = await runnerFor(model).ask(recipe, 's', 'skin', {});
  const file = writeSkinnedGltf(model, skin, 'glb');
  const gltf = await new GLTFLoader().parseAsync(file.slice().buffer as ArrayBuffer, '');
  return { skin, file, gltf };
}

/** Where three.js draws the vertices now. */
function drawn({ scene }: GLTF): Float64Array {
  scene.updateMatrixWorld(true);
  let found: SkinnedMesh | undefined;
  scene.traverse((object: Object3D) => {
    if ((object as SkinnedMesh).isSkinnedMesh) found = object as SkinnedMesh;
  });
  const mesh = found!;
  mesh.skeleton.update();
  const count = mesh.geometry.attributes.position!.count;
  const out = new Float64Array(3 * count);
  const at = new Vector3();
  for (let v = 0; v < count; v++) {
    mesh.getVertexPosition(v, at).applyMatrix4(mesh.matrixWorld);
    out.set(at.toArray(), 3 * v);
  }
  return out;
}

/** Largest and mean distance, in shares of the model's diagonal at rest. */
function apart(a: Float64Array, b: Float64Array, unit = 1) {
  expect(a.length).toBe(b.length);
  const diagonal = Math.hypot(0.6, LENGTH, 0.6) * unit;
  const far = Array.from({ length: a.length / 3 }, (_, v) =>
    Math.hypot(...[0, 1, 2].map((k) => a[3 * v + k]! - b[3 * v + k]!)),
  );
  return { most: Math.max(...far) / diagonal, mean: far.reduce((s, x) => s + x, 0) / far.length / diagonal };
}

/** The kernel's vertices with a pose as the step's own posture. */
async function posed(curves: readonly ({ id: string } & CurvePosture)[]): Promise<Float64Array> {
  const recipe = recipeOf();
  const step = recipe.steps[0] as { curves: { id: string }[] };
  for (const [at, curve] of step.curves.entries())
    step.curves[at] = { ...curve, ...curves.find(({ id }) => id === curve.id) };
  return (await runnerFor(MODEL).run(recipe)).get('s')!.model.positions;
}

test('it opens in the pose of the step', async () => {
  const lower = bow(LOWER, 70);
  const { gltf } = await skinned(recipeOf({ posed: lower }));
  const { most, mean } = apart(drawn(gltf), await posed([{ id: 'lower', posed: lower }]));
  expect(most).toBeLessThan(0.01);
  expect(mean).toBeLessThan(0.002);
});

test('it plays the poses: at the time of each it stands as the kernel has it', async () => {
  const { gltf } = await skinned(recipeOf());
  const [clip] = gltf.animations;
  expect(gltf.animations).toHaveLength(1);
  expect(clip!.duration).toBeCloseTo(2.5, 5);
  const mixer = new AnimationMixer(gltf.scene);
  const action = mixer.clipAction(clip!);
  action.clampWhenFinished = true;
  action.setLoop(2200, 1);
  action.play();
  for (const { time, curves } of POSES) {
    mixer.setTime(time);
    const { most } = apart(drawn(gltf), await posed(curves));
    expect(most, `at ${time} s`).toBeLessThan(0.01);
  }
});

test('at rest every joint leaves the model as it is, and weights are whole', async () => {
  const { skin, gltf, file } = await skinned(recipeOf({}, { poses: [] }));
  expect(apart(drawn(gltf), MODEL.positions).most).toBeLessThan(1e-6);
  expect(gltf.animations).toEqual([]);
  expect(skin.joints).toHaveLength(1 + 2 * 32);
  expect(skin.rest).toHaveLength(JOINT * skin.joints.length);
  for (let v = 0; v < MODEL.positions.length / 3; v++) {
    const weights = [...skin.weights.subarray(4 * v, 4 * v + 4)];
    expect(weights.reduce((a, b) => a + b, 0)).toBeCloseTo(1, 5);
  }
  // Joints stand on the curves.
  const [x, y, z] = skin.rest.subarray(JOINT * 32, JOINT * 32 + 3);
  expect(Math.hypot(x!, y! - 1.1, z!)).toBeLessThan(1e-9);
  let bones = 0;
  gltf.scene.traverse((object) => {
    if (object instanceof Bone) bones++;
  });
  expect(bones).toBe(skin.joints.length);
  // What is read back here is the model at rest.
  expect(apart(readModel(file, 'm.glb').model.positions, MODEL.positions).most).toBeLessThan(1e-6);
});

test('units, axes and a place far off stay the file\u2019s', async () => {
  const far = MODEL.positions.map((x, k) => 1000 * x + (k % 3 === 0 ? 1e6 : 0));
  const model: Model = { ...MODEL, positions: far, unitMetres: 0.001, upAxis: 'z' };
  const moved = ([x, y, z]: Point): Point => [1000 * x + 1e6, 1000 * y, 1000 * z];
  const lower = bow(LOWER, 50);
  const recipe = recipeOf(
    {},
    {
      curves: [
        { id: 'lower', kind: 'skeleton', rest: LOWER.map(moved), posed: lower.map(moved), anchor: 'start' },
        { id: 'upper', kind: 'skeleton', rest: UPPER.map(moved) },
      ],
      poses: [],
    },
  );
  const { gltf } = await skinned(recipe, model);
  const wanted = (await posed([{ id: 'lower', posed: lower }])).slice();
  // Metres, y up.
  for (let v = 0; v < wanted.length; v += 3) {
    const [x, y, z] = wanted.subarray(v, v + 3);
    wanted.set([x! + 1000, z!, -y!], v);
  }
  expect(apart(drawn(gltf), wanted).most).toBeLessThan(0.01);
});
