import type { BufferGeometry, Mesh } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { STLLoader } from 'three/examples/jsm/loaders/STLLoader.js';
import { expect, test } from 'vitest';
import { writeModel } from '../../web/io';
import { makeModel, text } from './support';

// What is written here must be readable elsewhere: the loaders of three.js stand for the rest of the world.

const MODEL = {
  ...makeModel(
    [0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 1, 3],
    [
      [0, 1, 2, 3],
      [0, 1, 4],
      [1, 2, 4],
    ],
  ),
  colors: Uint8Array.from({ length: 20 }, (_, i) => (i % 4 === 3 ? 255 : 12 * i)),
  uvs: Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.25),
};

/** Positions of all triangle corners. */
function corners({ index, attributes }: BufferGeometry): number[][] {
  const at = (v: number) => [0, 1, 2].map((k) => attributes.position!.getComponent(v, k));
  const count = index?.count ?? attributes.position!.count;
  return Array.from({ length: count }, (_, i) => at(index ? index.getX(i) : i));
}

const WANTED = [0, 1, 2, 0, 2, 3, 0, 1, 4, 1, 2, 4].map((v) => [
  ...MODEL.positions.subarray(3 * v, 3 * v + 3),
]);
const bufferOf = (file: Uint8Array) => file.slice().buffer as ArrayBuffer;

test('PLY, binary and ascii', () => {
  for (const ascii of [false, true]) {
    const geometry = new PLYLoader().parse(bufferOf(writeModel(MODEL, 'ply', { ascii })));
    expect(corners(geometry)).toEqual(WANTED);
    expect(geometry.attributes.uv!.count).toBe(5);
    expect(geometry.attributes.color!.count).toBe(5);
  }
});

test('OBJ', () => {
  const group = new OBJLoader().parse(text(writeModel(MODEL, 'obj')));
  const { geometry } = group.children[0] as Mesh;
  expect(corners(geometry)).toEqual(WANTED);
  expect(geometry.attributes.uv!.count).toBe(12);
});

test('STL, binary and ascii', () => {
  for (const ascii of [false, true])
    expect(corners(new STLLoader().parse(bufferOf(writeModel(MODEL, 'stl', { ascii }))))).toEqual(WANTED);
});

test('GLB', async () => {
  const file = writeModel({ ...MODEL, vertexSets: { scalp: Uint32Array.of(1, 4) } }, 'glb');
  const { scene } = await new GLTFLoader().parseAsync(bufferOf(file), '');
  const meshes: Mesh[] = [];
  scene.traverse((object) => {
    if ((object as Mesh).isMesh) meshes.push(object as Mesh);
  });
  expect(meshes.length).toBe(1);
  const { geometry } = meshes[0]!;
  expect(corners(geometry)).toEqual(WANTED);
  expect([...geometry.attributes.uv!.array]).toEqual([0, 1, 1, 1, 1, 0, 0, 0, 0.5, 0.75]);
  expect(geometry.attributes.normal!.getZ(4)).toBeGreaterThan(0);
  expect([...geometry.attributes._scalp!.array].length).toBeGreaterThanOrEqual(5);
});
