// Mesh files: damaged, read, written in every format and read again.

import type { Model } from '../../../web/core/model';
import { type FileFormat, readModel, writeModel } from '../../../web/io';
import { allowance } from '../../../web/io/budget';
import { makeModel } from '../../io/make-model';
import { type Generator, must, outcomeOf } from '../generator';
import { bytesOf, mutateBytes, mutateText, textOf } from '../mutate';

const MODEL: Model = {
  ...makeModel(
    [0, 0, 0, 1, 0, 0, 1, 1, 0.123456789012345, 0, 1, 0, 2, 2, 2, 1e6, -3, 0.5],
    [
      [0, 1, 2, 3],
      [2, 1, 0],
      [0, 2, 4, 5, 1],
    ],
  ),
  colors: Uint8Array.from({ length: 24 }, (_, i) => 10 * i),
  colorAlpha: true,
  uvs: Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5, 0, 0),
  groups: [{ name: 'a', material: 'b', start: 0, end: 1 }],
  vertexSets: { scalp: Uint32Array.of(0, 2) },
  unitMetres: 0.01,
  upAxis: 'z',
};

const STRIPS =
  'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n' +
  'property list int int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n7 0 1 2 3 -1 1 2\n';
const OFF = 'OFF\n# a triangle\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';

const TEXTS: readonly (readonly [FileFormat, string])[] = [
  ['obj', textOf(writeModel(MODEL, 'obj'))],
  ['ply', textOf(writeModel(MODEL, 'ply', { ascii: true }))],
  ['stl', textOf(writeModel(MODEL, 'stl', { ascii: true }))],
  ['ply', STRIPS],
  ['off', OFF],
];
const BINARIES: readonly (readonly [FileFormat, Uint8Array])[] = (['ply', 'stl', 'glb'] as const).map(
  (format) => [format, writeModel(MODEL, format)],
);

const readAndWrite = (file: Uint8Array, name: string): Promise<string> =>
  outcomeOf(async () => {
    const { model } = readModel(file, name);
    checkModel(model, file.length);
    for (const format of ['obj', 'ply', 'stl', 'glb', 'gltf'] as const)
      await outcomeOf(() => checkModel(readModel(writeModel(model, format), `b.${format}`).model, 1e9));
  });

/** What the kernel and every writer take for granted. */
export function checkModel(model: Model, size: number): void {
  const { positions, faceOffsets, faceVertices, colors, uvs, uvIndices } = model;
  const vertices = positions.length / 3;
  must(Number.isInteger(vertices) && vertices > 0, `${positions.length} coordinates`);
  must(
    faceOffsets[0] === 0 && faceOffsets.at(-1) === faceVertices.length,
    'offsets that do not span the corners',
  );
  must(
    faceOffsets.every((at, f) => f === 0 || at >= faceOffsets[f - 1]! + 3),
    'a face of fewer than three corners',
  );
  must(!colors || colors.length === 4 * vertices, 'colours that are not one a vertex');
  must(
    !uvs || (uvIndices ? uvIndices.length === faceVertices.length : uvs.length === 2 * vertices),
    'uvs that do not fit',
  );
  const held = [positions, faceOffsets, faceVertices, colors, uvs, uvIndices];
  const bytes = held.reduce((sum, array) => sum + (array?.byteLength ?? 0), 0);
  must(bytes <= 2 * allowance('gltf', size), `${size} bytes that unfolded to ${bytes}`);
}

const names = ['a', '', 'A.PLY', 'a.constructor', 'b/c.obj', 'é.stl', 'a.glb'];

const meshes: readonly Generator[] = [
  {
    kind: 'mesh text',
    run(random) {
      const [format, text] = random.pick(TEXTS);
      const name = random.chance(0.9) ? `a.${format}` : random.pick(names);
      return readAndWrite(bytesOf(mutateText(random, text)), name);
    },
  },
  {
    kind: 'mesh bytes',
    run(random) {
      const [format, file] = random.chance(0.5)
        ? random.pick(BINARIES)
        : random.pick(TEXTS.map(([format, text]) => [format, bytesOf(text)] as const));
      const name = random.chance(0.9) ? `a.${format}` : random.pick(names);
      return readAndWrite(mutateBytes(random, file), name);
    },
  },
];
export default meshes;
