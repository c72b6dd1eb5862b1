// Files and names that ended in an error of the language instead of a sentence, or in a result that nobody could read.

import { expect, test } from 'vitest';
import { readModel, readProject, readStrands, writeModel, writeProject } from '../../web/io';
import { parseRecipe } from '../../web/recipe/parse';
import { bytes, codeOf, facesOf, makeModel, read } from '../io/support';
import { meter } from './bounded';

const base64 = (content: Uint8Array): string =>
  `data:application/octet-stream;base64,${Buffer.from(content).toString('base64')}`;

/** A triangle as glTF. */
function triangle() {
  const buffer = new Uint8Array(36 + 8 + 16);
  new Float32Array(buffer.buffer, 0, 9).set([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  return {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 } as Record<string, unknown>],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } } as Record<string, unknown>] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' } as Record<string, unknown>],
    bufferViews: [
      { buffer: 0, byteLength: 36 },
      { buffer: 0, byteOffset: 36, byteLength: 8 },
      { buffer: 0, byteOffset: 44, byteLength: 12 },
    ],
    buffers: [{ byteLength: buffer.length, uri: base64(buffer) }],
  };
}

function changed(change: (json: ReturnType<typeof triangle>) => void): Uint8Array {
  const json = triangle();
  change(json);
  return bytes(JSON.stringify(json));
}

const failure = (call: () => unknown): string => {
  const done = meter(expect.getState().currentTestName ?? '');
  try {
    call();
  } catch (error) {
    return `${(error as { code?: string }).code}: ${(error as Error).message}`;
  } finally {
    done();
  }
  return 'accepted';
};

test.each([
  ['a sparse index of -1, in a type of signed numbers', 5120],
  ['a sparse index of 0.5, in a type of fractions', 5126],
])('%s', (_, componentType) => {
  const file = changed(({ accessors }) => {
    const indices = { bufferView: 1, componentType };
    accessors[0]!.sparse = { count: 1, indices, values: { bufferView: 2 } };
  });
  expect(failure(() => read(file, 'a.gltf'))).toMatch(
    /^file-damaged: a\.gltf is not valid glTF: a sparse accessor/,
  );
});

test.each([
  ['signed', 5120, Int8Array.of(-1, 0, 1)],
  ['fractions', 5126, Float32Array.of(0, 0.5, 1)],
])('corners that are %s name no vertex', (_, componentType, values) => {
  const file = changed((json) => {
    const view = new Uint8Array(values.buffer);
    json.buffers.push({ byteLength: view.length, uri: base64(view) });
    json.bufferViews.push({ buffer: 1, byteLength: view.length });
    json.accessors.push({ bufferView: 3, componentType, count: 3, type: 'SCALAR' });
    json.meshes[0]!.primitives[0]!.indices = 1;
  });
  const [face] = facesOf(read(file, 'a.gltf'));
  expect(face!.filter((v) => v === 0xffffffff)).toHaveLength(1);
});

test('extras three thousand deep', () => {
  const deep = `${'['.repeat(3000)}${']'.repeat(3000)}`;
  const text = JSON.stringify({ ...triangle(), extras: 'DEEP' }).replace('"DEEP"', deep);
  expect(failure(() => read(bytes(text), 'a.gltf'))).toMatch(
    /^file-damaged: a\.gltf is not valid glTF: its JSON part is nested more than 200 deep\./,
  );
  const shallow = JSON.stringify({ ...triangle(), extras: 'DEEP ]]]' });
  expect(writeModel(read(bytes(shallow), 'a.gltf'), 'glb').length).toBeGreaterThan(100);
});

test('a buffer view of no bytes: what was read beyond it would be lost on the way out', () => {
  const file = changed(({ bufferViews }) => {
    bufferViews[0]!.byteLength = 0;
  });
  expect(failure(() => read(file, 'a.gltf'))).toMatch(
    /^file-damaged: .*accessor 0 ends beyond its buffer view, which has 0 bytes\./,
  );
});

test('matrices of 1e308', () => {
  const matrix = [1e308, 0, 0, 0, 0, 1e308, 0, 0, 0, 0, 1e308, 0, 1e308, 1e308, 1e308, 1];
  const nested = changed(({ nodes }) => {
    nodes[0] = { matrix, children: [1] };
    nodes.push({ matrix, mesh: 0 });
  });
  expect(failure(() => read(nested, 'a.gltf'))).toMatch(
    /^file-damaged: .*node 1 is moved or scaled beyond what numbers can hold\./,
  );
});

test('a form that glTF does not have is told without the words of a library', () => {
  const file = changed(({ accessors }) => {
    accessors[0]!.count = 'many';
  });
  expect(failure(() => read(file, 'a.gltf'))).toBe(
    'file-damaged: a.gltf is not valid glTF: “accessors.0.count” is not what glTF has there. ' +
      'Export it again from the program that made it.',
  );
});

test.each(['constructor', 'toString', '__proto__'])('a file that says “%s” where a type stands', (word) => {
  const gltf = changed(({ accessors }) => {
    accessors[0]!.type = word;
  });
  expect(failure(() => read(gltf, 'a.gltf'))).toMatch(
    /^file-damaged: .*accessor 0 has an unknown type or count\./,
  );
  const ply = `ply\nformat ascii 1.0\nelement vertex 1\nproperty ${word} x\nend_header\n0\n`;
  expect(failure(() => read(ply, 'a.ply'))).toMatch(
    /^file-damaged: The header of a\.ply makes no sense at line 4/,
  );
  expect(codeOf(() => read(`ply\nformat ${word} 1.0\nend_header\n`, 'a.ply'))).toBe('file-damaged');
  expect(failure(() => read('hello', `a.${word}`))).toBe(
    `format-unknown: a.${word} is in no format known here. Open a model in OBJ, PLY, STL or glTF (.glb).`,
  );
});

test('an ASCII STL with a stray vertex', () => {
  const facet =
    'facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n';
  for (const [text, code] of [
    [`solid a\nvertex 9 9 9\n${facet}endsolid a\n`, 'vertex-without-facet'],
    [`solid a\n${facet}vertex 9 9 9\nendsolid a\n`, 'vertex-without-facet'],
    [`solid a\nfacet normal 0 0 1\nvertex 9 9 9\n${facet}endsolid a\n`, 'facet-not-a-triangle'],
    [`solid a\n${facet}facet normal 0 0 1\nvertex 9 9 9\nendsolid a\n`, 'facet-not-a-triangle'],
  ] as const) {
    const { model, notes } = readModel(bytes(text), 'a.stl');
    expect([...model.positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    expect(facesOf(model)).toEqual([[0, 1, 2]]);
    expect(notes.map((note) => note.code)).toEqual([code]);
  }
});

test('OFF 0 0 0', () => {
  expect(failure(() => read('OFF 0 0 0\n', 'a.off'))).toBe(
    'file-not-a-mesh: a.off holds no vertex, so it holds no model. Open another file.',
  );
  expect(failure(() => read('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n1e9 0 1 2\n', 'a.off'))).toMatch(
    /^file-truncated: /,
  );
});

test('a line of an OBJ out to 1e39, which single precision lacks', () => {
  const near = 'v 0 0 0\nv 0 1 0\nl 1 2\n';
  expect(failure(() => readStrands(bytes('v 0 0 0\nv 1e39 0 0\nl 1 2\n'), 'a.obj'))).toMatch(/^no-strands: /);
  const { strands } = readStrands(bytes(`${near}v 1e39 0 0\nl 1 3\n`), 'a.obj');
  expect([...strands.points].every(Number.isFinite)).toBe(true);
});

test('a .hair file whose strands add up to nothing by running over', () => {
  const file = new Uint8Array(128 + 2 * 65536);
  const view = new DataView(file.buffer);
  file.set(bytes('HAIR'));
  view.setUint32(4, 65536, true);
  view.setUint32(12, 3, true);
  file.fill(255, 128);
  expect(failure(() => readStrands(file, 'a.hair'))).toBe(
    'file-damaged: a.hair is damaged: its strands have 4294967296 points together, but it announces 0. ' +
      'Export it again from the program that made it.',
  );
});

test('output names longer than a file system takes', () => {
  const recipe = (file: string) => ({
    lissom: 1,
    models: { m: { builtin: 'bar' } },
    steps: [{ id: 'd', type: 'deform', model: 'm', handles: [] }],
    outputs: [{ step: 'd', file }],
  });
  expect(failure(() => parseRecipe(recipe(`${'é'.repeat(120)}.ply`)))).toBe('accepted');
  expect(failure(() => parseRecipe(recipe(`${'é'.repeat(200)}.ply`)))).toMatch(
    /^recipe-invalid: outputs\[0\]\.file: expected a file name of at most 255 bytes, found /,
  );
});

test('drives are no part of a name', () => {
  const recipe = (model: string, out: string) => ({
    lissom: 1,
    models: { m: { file: model } },
    steps: [{ id: 'd', type: 'deform', model: 'm', handles: [] }],
    outputs: [{ step: 'd', file: out }],
  });
  expect(failure(() => parseRecipe(recipe('a.ply', 'D:x.ply')))).toMatch(
    /^recipe-invalid: outputs\[0\]\.file: expected a file name without a drive such as "D:", found "D:x\.ply"\.$/,
  );
  expect(failure(() => parseRecipe(recipe('c:\\a.ply', 'x.ply')))).toContain(
    'models.m.file: expected a file name without a drive',
  );
  expect(failure(() => parseRecipe(recipe('ab: c.ply', 'x.ply')))).toBe('accepted');
});

test.each(['constructor', 'prototype', '__proto__'])('a model named %s is refused, not dropped', (name) => {
  const text = `{"lissom":1,"models":{"${name}":{"builtin":"bar"}},"steps":[]}`;
  expect(failure(() => parseRecipe(text))).toBe(
    `recipe-invalid: models.${name}: a model cannot have this name; choose another.`,
  );
});

test('a project file called __proto__ is refused, not dropped', () => {
  const content = writeModel(makeModel([0, 0, 0, 1, 0, 0, 0, 1, 0], [[0, 1, 2]]), 'ply');
  for (const name of ['__proto__', '__proto__/a.ply'])
    expect(failure(() => writeProject({ recipeJson: '{}', files: new Map([[name, content]]) }))).toBe(
      `zip-unsafe-name: A model cannot be called “${name}” in a project. Rename it.`,
    );
  const files = new Map([['constructor', content]]);
  expect(readProject(writeProject({ recipeJson: '{}', files })).files.get('constructor')).toEqual(content);
});
