import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { breaches, headerBreaches, importsOf, includeBreaches, includesOf } from './architecture';
import { filesUnder } from './files';

const root = fileURLToPath(new URL('..', import.meta.url));

const text = (file: string) => readFileSync(path.join(root, file), 'utf8');

test('no file of web/ imports from a floor above its own', () => {
  const files = filesUnder('web', ['.ts', '.tsx']);
  expect(files.length).toBeGreaterThan(20);
  expect(files.flatMap((file) => breaches(file, importsOf(text(file))))).toEqual([]);
});

test('no room of wasm/ includes a sibling, and none knows Emscripten', () => {
  const files = [...filesUnder('wasm/include', ['.h']), ...filesUnder('wasm/src', ['.h', '.cpp'])];
  expect(files.length).toBeGreaterThan(10);
  expect(files.flatMap((file) => includeBreaches(file, includesOf(text(file))))).toEqual([]);
});

test('every header of wasm/ has a test of its stem that includes it', () => {
  const headers = filesUnder('wasm/include', ['.h']);
  const tests = filesUnder('tests/wasm', ['_test.cpp']);
  expect(headers.length).toBeGreaterThan(60);
  expect(headerBreaches(headers, new Map(tests.map((file) => [file, includesOf(text(file))])))).toEqual([]);
});

test.each<[what: string, file: string, included: string, breaches: number]>([
  ['its own test', 'tests/wasm/solve/order_test.cpp', 'lissom/solve/order.h', 0],
  ['a test that looks elsewhere', 'tests/wasm/solve/order_test.cpp', 'lissom/solve/graph.h', 1],
  ['a test of another name', 'tests/wasm/solve/ordering_test.cpp', 'lissom/solve/order.h', 1],
  ['a test in another room', 'tests/wasm/mesh/order_test.cpp', 'lissom/solve/order.h', 1],
])('a header with %s', (_, file, included, count) => {
  const found = headerBreaches(['wasm/include/lissom/solve/order.h'], new Map([[file, [included]]]));
  expect(found).toHaveLength(count);
});

const forbidden: [file: string, imported: string][] = [
  ['web/core/ids.ts', '../recipe/recipe'],
  ['web/recipe/steps/deform.ts', '../../kernel/contract'],
  ['web/kernel/serve.ts', '../run/types'],
  ['web/io/obj.ts', '../view/normals'],
  ['web/view/mesh.ts', '../ui/app'],
  ['web/tools/deform/drag.ts', '../../app/state'],
  ['web/app/state.ts', '../ui/app'],
  ['web/cli/main.ts', '../view/mesh'],
  ['web/run/evaluate.ts', '../cli/main'],
  ['web/io/gltf.ts', 'three'],
  ['web/ui/app.tsx', 'three/addons/controls/OrbitControls.js'],
  ['web/tools/pick.ts', 'three-mesh-bvh'],
  ['web/run/evaluate.ts', '../../wasm/dist/kernel.mjs'],
  ['web/app/start.ts', '../../wasm/dist/kernel.wasm?url'],
  ['web/recipe/recipe.ts', 'preact'],
  ['web/io/obj.ts', 'node:fs'],
];
test.each(forbidden)('%s may not import %s', (file, imported) => {
  expect(breaches(file, [imported])).toHaveLength(1);
});

const allowed: [file: string, imported: string][] = [
  ['web/recipe/recipe.ts', '../core/errors'],
  ['web/recipe/recipe.ts', 'valibot'],
  ['web/recipe/recipe.ts', './steps/deform'],
  ['web/kernel/module.ts', '../../wasm/dist/kernel.mjs'],
  ['web/kernel/node.ts', 'node:fs'],
  ['web/run/evaluate.ts', '../kernel/contract'],
  ['web/view/mesh.ts', 'three'],
  ['web/cli/main.ts', '../io/formats'],
  ['web/cli/main.ts', '../kernel/node'],
  ['web/cli/main.ts', 'node:fs/promises'],
  ['web/main.tsx', './ui/app'],
];
test.each(allowed)('%s may import %s', (file, imported) => {
  expect(breaches(file, [imported])).toEqual([]);
});

test.each([
  ['wasm/src/solve/order.cpp', 'lissom/deform/measure.h'],
  ['wasm/include/lissom/mesh/types.h', 'lissom/solve/sparse_cholesky.h'],
  ['wasm/src/hair/field.cpp', 'lissom/deform/measure.h'],
  ['wasm/src/deform/session.cpp', 'lissom/merge/seam.h'],
  ['wasm/src/curve/thin.cpp', '../match/pairs.h'],
  ['wasm/src/mesh/types.cpp', 'emscripten/val.h'],
])('%s may not include %s', (file, included) => {
  expect(includeBreaches(file, [included])).toHaveLength(1);
});

test.each([
  ['wasm/src/merge/seam.cpp', 'lissom/deform/measure.h'],
  ['wasm/src/match/pairs.cpp', 'lissom/deform/measure.h'],
  ['wasm/src/deform/session.cpp', 'lissom/solve/sparse_cholesky.h'],
  ['wasm/src/solve/order.cpp', 'graph.h'],
  ['wasm/src/mesh/types.cpp', 'Eigen/Core'],
])('%s may include %s', (file, included) => {
  expect(includeBreaches(file, [included])).toEqual([]);
});

test('imports are found in every form they are written', () => {
  const source = `
    import { a } from './a';
    import type {
      B,
    } from "../b";
    import './c.css';
    export * from './d';
    const e = await import('./e');
    const f = new Worker(new URL('./f.ts', import.meta.url), { type: 'module' });
    // import { g } from './g';
  `;
  expect(importsOf(source)).toEqual(['./a', '../b', './c.css', './d', './e', './f.ts']);
  expect(includesOf('#include "lissom/a.h"\n#  include <vector>\n// #include "no.h"')).toEqual([
    'lissom/a.h',
    'vector',
  ]);
});
