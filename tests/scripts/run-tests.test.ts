// How the test suite counts its layers, some of which run beside others.

import { afterEach, beforeEach, expect, test, vi } from 'vitest';

const { runTests } = await import(new URL('../../scripts/test.mjs', import.meta.url).href);

let printed: string;
beforeEach(() => {
  printed = '';
  const note = (text: unknown) => {
    printed += text;
    return true;
  };
  vi.spyOn(console, 'log').mockImplementation((text) => void note(`${text}\n`));
  vi.spyOn(process.stdout, 'write').mockImplementation(note);
});
afterEach(() => vi.restoreAllMocks());

const counted = (passed: number, failed = 0, skipped = 0) => ({ passed, failed, skipped });
const last = () => printed.trimEnd().split('\n').at(-1);

test('what runs beside other layers is waited for, told whole and counted', async () => {
  const order: string[] = [];
  let finish = () => {};
  const gate = new Promise<void>((resolve) => {
    finish = resolve;
  });
  const status = await runTests(
    [],
    [
      {
        name: 'slow',
        build: async () => order.push('built'),
        beside: async () => {
          await gate;
          order.push('slow');
          return { ...counted(3, 1, 2), output: 'all of its output\n' };
        },
      },
      {
        name: 'quick',
        run: async () => {
          order.push('quick');
          finish();
          return counted(5);
        },
      },
    ],
  );
  expect(order).toEqual(['built', 'quick', 'slow']);
  expect(printed).toContain('» Tested: slow\nall of its output\n');
  expect(printed).toMatch(/^slow +3 passed, 1 failed, 2 skipped +\d+ s$/m);
  expect(last()).toBe('8 passed, 1 failed, 2 skipped');
  expect(status).toBe(1);
});

test.each([
  [
    'cannot be built',
    { build: () => Promise.reject(new Error('no compiler')), beside: async () => counted(1) },
  ],
  ['breaks off', { build: async () => '', beside: () => Promise.reject(new Error('no compiler')) }],
  ['breaks off alone', { run: () => Promise.reject(new Error('no compiler')) }],
])('a layer that %s is one failure, with its reason, and the others go on', async (_, layer) => {
  const status = await runTests(
    [],
    [
      { name: 'bad', ...layer },
      { name: 'good', run: async () => counted(7) },
    ],
  );
  expect(printed).toContain('no compiler');
  expect(last()).toBe('7 passed, 1 failed');
  expect(status).toBe(1);
});

test('layers can be chosen by name', async () => {
  const layer = (name: string) => ({ name, run: async () => counted(1) });
  expect(await runTests(['b'], ['a', 'b', 'c'].map(layer))).toBe(0);
  expect(last()).toBe('1 passed, 0 failed');
});
