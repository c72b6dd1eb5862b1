import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { t, tCode } from '../../web/app/i18n';
import { Tab } from './world';

const root = fileURLToPath(new URL('../../web', import.meta.url));
const sources = ['app', 'ui', 'main.tsx'].flatMap((part) => filesUnder(path.join(root, part)));
const source = sources.map((file) => readFileSync(file, 'utf8')).join('\n');

function filesUnder(file: string): string[] {
  if (/\.tsx?$/.test(file)) return [file];
  if (path.extname(file)) return [];
  return readdirSync(file).flatMap((name) => filesUnder(path.join(file, name)));
}

const folder = path.join(root, 'app/locales/en');
/** The files of words by name; names of wings are no messages. */
const files = readdirSync(folder)
  .filter((name) => name !== 'wings.json')
  .map((name) => [name, Object.keys(JSON.parse(readFileSync(path.join(folder, name), 'utf8')))] as const);
const keys = files.flatMap(([, held]) => held);

/** Keys that are put together from a prefix and a code, as in `history.${label}`. */
const composed = [...source.matchAll(/[`']([a-z-]+(?:\.[a-z-]+)*\.)(?:\$\{|')/g)].map(
  ([, prefix]) => prefix!,
);

test('no message is there for nothing', () => {
  const unused = keys.filter(
    (key) => !source.includes(`'${key}'`) && !composed.some((prefix) => key.startsWith(prefix)),
  );
  expect(unused).toEqual([]);
});

test('no key is claimed by two files', () => {
  expect(keys.filter((key, i) => keys.indexOf(key) !== i)).toEqual([]);
});

test('every command and group has a title, and no title lacks its command', async () => {
  const { commands, wings } = new Tab().app;
  await wings.loadAll();
  for (const { title, group } of commands.all) {
    expect(t(title)).not.toBe('');
    expect(keys).toContain(`ui.group.${group}`);
  }
  const titles = new Set<string>(commands.all.map(({ title }) => title));
  const orphans = keys.filter((key) => key.startsWith('command.') && !titles.has(key));
  expect(orphans).toEqual([]);
});

test('every finding the kernel and the readers know has a message of its own', () => {
  const wasm = ['src/mesh', 'src/deform'].flatMap((folder) =>
    readdirSync(path.join(root, '../wasm', folder)).map((name) => path.join(root, '../wasm', folder, name)),
  );
  const io = filesUnder(path.join(root, 'io'));
  const codes = [...wasm, ...io].flatMap((file) =>
    [...readFileSync(file, 'utf8').matchAll(/\badd\(\s*["']([a-z]+(?:-[a-z]+)+)["']/g)].map(
      ([, code]) => code!,
    ),
  );
  expect(codes.length).toBeGreaterThan(10);
  const silent = codes.filter((code) => !keys.includes(`finding.${code}`));
  expect(silent).toEqual([]);
});

test('placeholders are filled, numbers in the notation of the language', () => {
  expect(t('toast.exported', { name: 'a.ply', vertices: 12345, reordered: 0 })).toBe(
    'a.ply written: 12,345 vertices, 0 reordered.',
  );
});

test('a number takes the word for one or for more', () => {
  expect(t('finding.open-boundary', { count: 1 })).toBe('1 open boundary.');
  expect(t('finding.open-boundary', { count: 2 })).toBe('2 open boundaries.');
});

test('a code without a message falls back to one that names it', () => {
  expect(tCode('finding.', 'never-heard-of', 'finding.unknown', { count: 3 })).toBe('never-heard-of: 3');
});
