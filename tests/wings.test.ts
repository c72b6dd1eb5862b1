import { existsSync, readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { importsOf, lazyImportsOf } from './architecture';
import { filesUnder } from './files';
import { circle, forgotten, namings, wingBreaches, wingOf } from './wings';

const root = fileURLToPath(new URL('..', import.meta.url));
const text = (file: string) => readFileSync(path.join(root, file), 'utf8');
const sources = filesUnder('web', ['.ts', '.tsx']);

/** Each wing has a folder with its door on the app floor. */
const wings = readdirSync(path.join(root, 'web/app')).filter((name) =>
  existsSync(path.join(root, 'web/app', name, 'wing.ts')),
);

test('there are wings', () => {
  expect(wings.length).toBeGreaterThanOrEqual(3);
});

test('only registries reach into a wing, and no wing into another', () => {
  expect(sources.flatMap((file) => wingBreaches(file, importsOf(text(file)), wings))).toEqual([]);
});

test.each(wings)('no registry has forgotten %s', (wing) => {
  const asksKernel = existsSync(path.join(root, 'web/kernel/handlers', `${wing}.ts`));
  expect(forgotten(wing, text, asksKernel)).toEqual([]);
});

test('shared files do not say the name of a wing', () => {
  expect(sources.flatMap((file) => namings(file, text(file), wings))).toEqual([]);
});

test('imports lead in no circle, types included', () => {
  const known = new Set(sources);
  const resolve = (file: string, name: string): string[] => {
    const at = path.posix.join(path.posix.dirname(file), name);
    return [at, `${at}.ts`, `${at}.tsx`, `${at}/index.ts`].filter((each) => known.has(each)).slice(0, 1);
  };
  const graph = new Map(
    sources.map((file) => {
      // What is loaded when it is needed is no part of what needs it.
      const lazy = new Set(lazyImportsOf(text(file)));
      const names = importsOf(text(file)).filter((name) => name.startsWith('.') && !lazy.has(name));
      return [file, names.flatMap((name) => resolve(file, name))] as const;
    }),
  );
  expect(circle(graph)).toBeUndefined();
});

test('the rooms that many share stay small enough to hold in the head', () => {
  const lines = (file: string) => text(file).split('\n').length - 1;
  expect(lines('web/view/viewport.ts')).toBeLessThan(450);
  expect(lines('web/app/evaluation.ts')).toBeLessThan(150);
});

test.each([
  ['web/app/hair/host.ts', '../merge/state', 1],
  ['web/app/state.ts', './hair/state', 1],
  ['web/ui/shell/stage.tsx', '../merge/merge-stage', 1],
  ['web/tools/deform/drag.ts', '../hair/stroke', 1],
  ['web/run/steps/merge.ts', './hair/scalp', 1],
  ['web/kernel/handlers/hair.ts', './deform', 1],
  ['web/app/hair/host.ts', './state', 0],
  ['web/app/hair/host.ts', '../../tools/hair/style', 0],
  ['web/app/hair/host.ts', '../state', 0],
  ['web/app/wings.ts', './hair/wing', 0],
  ['web/run/steps/hair.ts', './step-runner', 0],
])('%s that imports %s is told %i times', (file, imported, times) => {
  expect(wingBreaches(file, [imported], ['deform', 'hair', 'merge'])).toHaveLength(times);
});

test('a wing is known by its folder or its stem', () => {
  const of = (file: string) => wingOf(file, ['deform', 'hair']);
  expect(of('web/recipe/steps/deform-edits.ts')).toBe('deform');
  expect(of('web/app/locales/en/hair.json')).toBe('hair');
  expect(of('web/kernel/contract/model.ts')).toBeUndefined();
  expect(of('web/app/document.ts')).toBeUndefined();
});

test('a name in a shared file is told, wherever in a word it begins', () => {
  const told = (line: string) => namings('web/app/state.ts', line, ['hair']).length;
  expect([told('// the hair step'), told('state.hairStep'), told('HairState'), told('chairs')]).toEqual([
    1, 1, 1, 0,
  ]);
});

test('a circle is found wherever it begins', () => {
  const graph = (edges: Record<string, string[]>) => new Map(Object.entries(edges));
  expect(circle(graph({ a: ['b'], b: ['c'], c: ['b'] }))).toEqual(['b', 'c', 'b']);
  expect(circle(graph({ a: ['b', 'c'], b: ['c'], c: [] }))).toBeUndefined();
});
