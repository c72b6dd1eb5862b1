// The rules of wings: each knows its own folder on every floor and the shared floors below, never another wing; only
// the registries know them all. Pure, so that they can be tried on made-up files.

import path from 'node:path';

/** The files that name wings, a line each: whoever adds one, adds to all of these and to nothing else that exists. */
export const REGISTRIES: readonly string[] = [
  'web/recipe/recipe.ts',
  'web/kernel/contract.ts',
  'web/kernel/handlers/all.ts',
  'wasm/bindings/kernel.d.ts',
  'web/run/steps/all.ts',
  'web/app/wings.ts',
  'web/app/i18n.ts',
  'web/app/locales/en/wings.json',
  'web/ui/wings.tsx',
];

/** Where files of a wing lie, by its name: a folder, or a file and its likes (`deform.ts`, `deform-edits.ts`). */
const FOLDERS = ['web/app', 'web/ui', 'web/tools', 'web/view', 'web/run/steps', 'web/recipe/steps'];
const STEMS = [
  'web/recipe/steps',
  'web/run/steps',
  'web/kernel/handlers',
  'web/kernel/contract',
  'web/app/locales/en',
];

/** @returns the wing that a file (a path from the root) is part of, `undefined` for a shared one */
export function wingOf(file: string, wings: readonly string[]): string | undefined {
  const folder = path.posix.dirname(file);
  return wings.find(
    (wing) =>
      FOLDERS.some((floor) => file.startsWith(`${floor}/${wing}/`)) ||
      (STEMS.includes(folder) && new RegExp(`^${wing}(-[a-z-]+)?(\\.|$)`).test(path.posix.basename(file))),
  );
}

/** @returns one sentence per import of `file` that reaches into a wing it is no part of */
export function wingBreaches(file: string, imports: readonly string[], wings: readonly string[]): string[] {
  if (REGISTRIES.includes(file)) return [];
  const own = wingOf(file, wings);
  return imports
    .filter((name) => name.startsWith('.'))
    .filter((name) => {
      const target = wingOf(path.posix.join(path.posix.dirname(file), name), wings);
      return target !== undefined && target !== own;
    })
    .map((name) => `${file} imports ${name}`);
}

/**
 * The kernel's two name only wings that ask the kernel for something of their own.
 * @returns the registries that do not name a wing
 */
export const forgotten = (wing: string, textOf: (file: string) => string, asksKernel: boolean): string[] =>
  REGISTRIES.filter((file) => asksKernel || !/^web\/kernel|^wasm/.test(file)).filter(
    (file) => !new RegExp(`\\b${wing}`).test(textOf(file)),
  );

/** Shared files: they may not even say a wing's name. */
const SHARED = [
  /^web\/app\/[^/]+\.tsx?$/,
  /^web\/app\/commands\//,
  /^web\/ui\/(shell|dialogs|controls)\//,
  /^web\/ui\/[^/]+\.tsx?$/,
  /^web\/view\/[^/]+\.ts$/,
  /^web\/view\/overlays\//,
  /^web\/tools\/(stroke\/|[^/]+\.ts$)/,
  /^web\/run\/[^/]+\.ts$/,
  /^web\/kernel\/[^/]+\.ts$/,
];

/** What browser and libraries call their own things, whatever wings are called. */
const PLATFORM = /\b(dataTransfer|matchMedia)\b|\bblend(Src|Dst|Alpha|Equation)\b/g;

/** @returns the lines of a shared file that say the name of a wing */
export function namings(file: string, source: string, wings: readonly string[]): string[] {
  if (REGISTRIES.includes(file) || !SHARED.some((pattern) => pattern.test(file))) return [];
  const words = wings.map(
    (wing) => `(?<![A-Za-z])${wing}(?![a-z])|${wing[0]!.toUpperCase()}${wing.slice(1)}(?![a-z])`,
  );
  const names = new RegExp(words.join('|'));
  return source
    .split('\n')
    .filter((line) => names.test(line.replace(PLATFORM, '')))
    .map((line) => `${file}: ${line.trim()}`);
}

/** The first circle among imports, as the files it leads through; `undefined` where there is none. */
export function circle(graph: ReadonlyMap<string, readonly string[]>): readonly string[] | undefined {
  const done = new Set<string>();
  const under: string[] = [];
  const visit = (file: string): readonly string[] | undefined => {
    if (done.has(file)) return undefined;
    const at = under.indexOf(file);
    if (at >= 0) return [...under.slice(at), file];
    under.push(file);
    for (const target of graph.get(file) ?? []) {
      const found = visit(target);
      if (found) return found;
    }
    under.pop();
    done.add(file);
    return undefined;
  };
  for (const file of graph.keys()) {
    const found = visit(file);
    if (found) return found;
  }
  return undefined;
}
