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

/** Names in quotes in what the kernel's rooms of matching are made of. */
function namedIn(folders: readonly string[], ...patterns: readonly RegExp[]): string[] {
  const found = folders.flatMap((folder) =>
    readdirSync(path.join(root, '..', folder))
      .map((name) => readFileSync(path.join(root, '..', folder, name), 'utf8'))
      .flatMap((text) => patterns.flatMap((pattern) => [...text.matchAll(pattern)].map(([, code]) => code!))),
  );
  return [...new Set(found)].sort();
}
const MATCHING = ['wasm/src/match', 'wasm/src/wear'];

test('every warning that a match, a blend or a garment can bring has a sentence, and says what to do', () => {
  const codes = namedIn(
    MATCHING,
    /\bwarn\(\s*"([a-z]+(?:-[a-z]+)*)"/g,
    /\bpush_back\(\{?\s*"([a-z]+(?:-[a-z]+)*)"/g,
    /\bMatchWarning \w+\{\s*"([a-z]+(?:-[a-z]+)*)"/g,
  );
  expect(codes).toEqual(expect.arrayContaining(['poses-differ', 'markers-moved', 'webs', 'inside-left']));
  // No warning is made in a way that the patterns do not see: the headers list them all.
  const manual = ['match/match_session.h', 'wear/blend_session.h', 'wear/dress_session.h']
    .map((name) => readFileSync(path.join(root, '../wasm/include/lissom', name), 'utf8'))
    .flatMap((text) =>
      [...text.matchAll(/warnings;\s*((?:\/\/\/<[^\n]*\n\s*)+)/g)].map(([, comment]) => comment!),
    )
    .flatMap((comment) => [...comment.matchAll(/`([a-z]+(?:-[a-z]+)*)`/g)].map(([, code]) => code!));
  expect(manual.filter((code) => !codes.includes(code))).toEqual([]);
  expect(codes.filter((code) => !manual.includes(code))).toEqual([]);
  expect(codes.filter((code) => !keys.includes(`finding.${code}`))).toEqual([]);
  const sentence = (code: string) =>
    tCode('finding.', code, 'finding.unknown', { count: 2, numbers: '1, 2' });
  expect(codes.filter((code) => !/[.:?] [A-Z]|: [a-z]/.test(sentence(code)))).toEqual([]);
});

/** Only a caller of the kernel can bring these, never what is marked in the app. */
const NEVER = ['not-begun', 'wrong-size'];

test('every refusal of the kernel that marks on matched models can bring has words of its own', () => {
  const refused = namedIn(['wasm/src/match'], /\bInvalidInput\("([a-z-]+)"/g);
  expect(refused.length).toBeGreaterThan(8);
  const silent = refused.filter((code) => !NEVER.includes(code) && !keys.includes(`match.problem.${code}`));
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
