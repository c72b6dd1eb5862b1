import fc from 'fast-check';
import { expect, test } from 'vitest';
import { IDENTITY } from '../../web/core/affine';
import { LissomError } from '../../web/core/errors';
import { readModel, readProject, writeModel, writeProject } from '../../web/io';
import { bytes, makeModel, read } from './support';

const MODEL = {
  ...makeModel(
    [0, 0, 0, 1, 0, 0, 1, 1, 0.123456789012345, 0, 1, 0],
    [
      [0, 1, 2, 3],
      [2, 1, 0],
    ],
  ),
  colors: Uint8Array.from({ length: 16 }, (_, i) => 10 * i),
  colorAlpha: true,
  uvs: Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1),
  groups: [{ name: 'a', material: 'b', start: 0, end: 1 }],
};

const FILES: [string, Uint8Array][] = (['obj', 'ply', 'stl', 'glb', 'gltf'] as const).map((format) => [
  format,
  writeModel(MODEL, format),
]);
const RIGGED = {
  ...MODEL,
  rig: {
    joints: [
      { name: 'hip', parent: -1, bind: IDENTITY },
      { name: 'knee', parent: 0, bind: IDENTITY },
    ],
    influences: 4 as const,
    indices: Uint16Array.from({ length: 16 }, (_, k) => k % 2),
    weights: new Float32Array(16).fill(0.25),
  },
};
for (const format of ['glb', 'gltf'] as const) FILES.push([`rigged ${format}`, writeModel(RIGGED, format)]);
for (const format of ['ply', 'stl'] as const)
  FILES.push([`ascii ${format}`, writeModel(MODEL, format, { ascii: true })]);
FILES.push(['off', bytes('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n')]);
FILES.push([
  'strips',
  bytes(
    'ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\nproperty list int int vertex_index\nend_header\n5 -1 0 1 2 3\n',
  ),
]);

/** Bytes changed, removed and repeated at random places. */
const damage = (file: Uint8Array) =>
  fc
    .array(fc.tuple(fc.nat(file.length - 1), fc.nat(255), fc.constantFrom('set', 'cut', 'repeat', 'end')), {
      minLength: 1,
      maxLength: 4,
    })
    .map((edits) => {
      const out = [...file];
      for (const [at, value, kind] of edits) {
        if (kind === 'set') out[at] = value;
        else if (kind === 'cut') out.splice(at, 1 + (value % 9));
        else if (kind === 'repeat') out.splice(at, 0, ...out.slice(at, at + (value % 30)));
        else out.length = Math.min(out.length, at + 1);
      }
      return Uint8Array.from(out, (b) => b ?? 0);
    });

const refusedOrDone = (call: () => unknown) => {
  try {
    call();
  } catch (error) {
    if (!(error instanceof LissomError)) throw error;
    expect(error.message).toMatch(/\.$/);
  }
};

test.each(FILES)(
  'a damaged file ends in a sentence or in a model that can be written again: %s',
  (name, file) => {
    fc.assert(
      fc.property(damage(file), (broken) => {
        refusedOrDone(() => {
          const { model } = readModel(broken, `a.${name.split(' ').at(-1)}`);
          for (const format of ['obj', 'ply', 'stl', 'glb'] as const)
            refusedOrDone(() => read(writeModel(model, format), 'b'));
        });
      }),
      { numRuns: 200 },
    );
  },
);

test('a damaged project ends in a sentence', () => {
  const file = writeProject({ recipeJson: '{}', files: new Map([['a.ply', writeModel(MODEL, 'ply')]]) });
  fc.assert(
    fc.property(damage(file), (broken) => refusedOrDone(() => readProject(broken))),
    { numRuns: 200 },
  );
});
