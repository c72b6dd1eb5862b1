// The rules of the house: who may import whom. Pure, so that they can be tried on made-up imports.

import path from 'node:path';

/** From the ground up: a floor may import those before it. */
const FLOORS = ['core', 'recipe', 'kernel', 'run', 'io', 'view', 'tools', 'app', 'ui'];
/** The command line is a house of its own on the lower floors. */
const CLI_STANDS_ON = ['core', 'recipe', 'kernel', 'run', 'io', 'cli'];
/** Packages that only these floors may know; every other package is free. */
const PACKAGES: { name: RegExp; floors: string[] }[] = [
  { name: /^three(\/|$)|^three-mesh-bvh/, floors: ['view'] },
  { name: /^node:/, floors: ['kernel', 'cli'] },
  { name: /^preact|^@preact\/signals|^browser-fs-access|^idb/, floors: ['view', 'tools', 'app', 'ui'] },
];

/** @returns one sentence per import of `file` (a path from the root) that breaks a rule */
export function breaches(file: string, imports: readonly string[]): string[] {
  const [, floor = ''] = file.split('/');
  if (file.split('/').length < 3) return []; // web/main.tsx wires everything together
  return imports.filter((name) => !mayImport(floor, file, name)).map((name) => `${file} imports ${name}`);
}

function mayImport(floor: string, file: string, name: string): boolean {
  if (!name.startsWith('.'))
    return PACKAGES.every((rule) => !rule.name.test(name) || rule.floors.includes(floor));
  const [house, target = ''] = path.posix.join(path.posix.dirname(file), name).split('/');
  if (house === 'wasm') return floor === 'kernel';
  if (house === 'package.json') return true;
  if (house !== 'web') return false;
  if (floor === 'cli') return CLI_STANDS_ON.includes(target);
  return FLOORS.includes(target) && FLOORS.indexOf(target) <= FLOORS.indexOf(floor);
}

export function importsOf(source: string): string[] {
  const code = source.replace(/^\s*\/\/.*$/gm, '');
  const forms =
    /(?:^|[\s;])(?:import|export)\s(?:[^'";]*?\sfrom\s*)?['"]([^'"]+)['"]|import\(\s*['"]([^'"]+)['"]|new URL\(\s*['"]([^'"]+)['"]/g;
  return [...code.matchAll(forms)].map((match) => match[1] ?? match[2] ?? match[3] ?? '');
}

/** Those that are loaded only when they are needed: `import()` and workers. */
export const lazyImportsOf = (source: string): string[] =>
  [...source.matchAll(/(?:\bimport\(|new URL\()\s*['"]([^'"]+)['"]/g)].map((match) => match[1] ?? '');

/** What a room may include beside itself, unless it says more below. */
const ROOM: readonly string[] = ['mesh', 'solve'];
const ROOMS: Record<string, readonly string[]> = {
  mesh: [],
  solve: ['mesh'],
  merge: ['mesh', 'solve', 'deform'],
  match: ['mesh', 'solve', 'deform'],
  isoline: ['mesh', 'solve', 'deform'],
};

/** @returns one sentence per include of `file` that breaks a rule */
export function includeBreaches(file: string, includes: readonly string[]): string[] {
  const room = roomOf(file);
  return includes
    .filter((name) => {
      if (name.startsWith('emscripten')) return true;
      const target = name.startsWith('lissom/')
        ? name.split('/')[1]
        : name.startsWith('.') && roomOf(path.posix.join(path.posix.dirname(file), name));
      return target && target !== room && !(ROOMS[room] ?? ROOM).includes(target);
    })
    .map((name) => `${file} includes ${name}`);
}

/** wasm/include/lissom/<room>/… or wasm/src/<room>/… */
const roomOf = (file: string): string => file.match(/^wasm\/(?:include\/lissom|src)\/([^/]+)\//)?.[1] ?? '';

export const includesOf = (source: string): string[] =>
  [...source.matchAll(/^\s*#\s*include\s*["<]([^">]+)[">]/gm)].map((match) => match[1] ?? '');

/**
 * A header is proved by a test of its own stem that includes it.
 * @param testIncludes what each test includes, by its path from the root
 * @returns one sentence per header without one
 */
export function headerBreaches(
  headers: readonly string[],
  testIncludes: ReadonlyMap<string, readonly string[]>,
): string[] {
  return headers.flatMap((header) => {
    const name = header.replace(/^wasm\/include\//, '');
    const test = name.replace(/^lissom\/(.*)\.h$/, 'tests/wasm/$1_test.cpp');
    const includes = testIncludes.get(test);
    if (!includes) return [`${header} has no ${test}`];
    return includes.includes(name) ? [] : [`${test} does not include ${name}`];
  });
}
