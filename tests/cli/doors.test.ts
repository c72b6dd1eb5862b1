// What the command line does not open, and what ends a run.

import { execFileSync } from 'node:child_process';
import { mkdirSync, symlinkSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { readable } from '../../web/cli/files';
import { writeModel } from '../../web/io/formats';
import { FakeKernel } from '../run/fake-kernel';
import { sheet } from './shapes';
import { deformRecipe, move, region, Shell } from './shell';

const model = writeModel(sheet(4, 3), 'ply');
const recipe = (file = 'm.ply') => deformRecipe([region([0, 1]), region([19], move(0, 0, 1))], {}, file);

/** A shell with a recipe in a folder of its own, and a model beside that folder. */
function besides(file: string) {
  const shell = new Shell({ kernel: async () => new FakeKernel() });
  mkdirSync(shell.path('inner'));
  shell.write('m.ply', model);
  shell.write('inner/r.json', recipe(file));
  const lissom = (...argv: string[]) => shell.lissom([...argv, shell.path('inner/r.json')]);
  return { shell, lissom };
}

describe('a model outside the recipe’s folder', () => {
  test.each(['../m.ply', '/etc/hostname', '../nothing-there.ply', '..', 'inner/../../m.ply'])(
    '%s is not opened',
    async (file) => {
      const { shell, lissom } = besides(file);
      for (const command of ['check', 'run']) {
        const { status, stderr } = await lissom(
          command,
          ...(command === 'run' ? ['--out', shell.path('o')] : []),
        );
        expect([status, stderr]).toEqual([
          2,
          `error: model-outside: models.m (${file}): ${file} lies outside the recipe's folder; ` +
            'move it beside the recipe, or allow it with --allow-outside.\n',
        ]);
      }
      expect(shell.files('o')).toEqual([]);
    },
  );

  test('is opened with --allow-outside', async () => {
    const { shell, lissom } = besides('../m.ply');
    expect(await lissom('check', '--allow-outside')).toEqual({ status: 0, stdout: '', stderr: '' });
    expect(await lissom('run', '--allow-outside', '--out', shell.path('o'))).toMatchObject({ status: 0 });
    expect(shell.files('o')).toEqual(['o.ply']);
  });

  test('is one too where a link in the folder leads there; a folder within is not outside', async () => {
    const { shell, lissom } = besides('linked.ply');
    symlinkSync(shell.path('m.ply'), shell.path('inner/linked.ply'));
    expect((await lissom('check')).stderr).toContain('model-outside');
    mkdirSync(shell.path('inner/..models'));
    shell.write('inner/..models/m.ply', model);
    shell.write('inner/r.json', recipe('..models/m.ply'));
    expect(await lissom('check')).toMatchObject({ status: 0, stderr: '' });
  });
});

describe('what is no file', () => {
  test('is refused without waiting for its end', async () => {
    const shell = new Shell();
    execFileSync('mkfifo', [shell.path('pipe')]);
    for (const [place, what] of [
      [shell.path('pipe'), 'a pipe'],
      ['/dev/zero', 'a device'],
      [shell.folder, 'a folder'],
    ] as const) {
      await expect(readable('model-not-found', place, 'mesh')).rejects.toMatchObject({
        code: 'file-unreadable',
        message: `${place} cannot be read (it is ${what}).`,
      });
      expect((await shell.lissom(['check', place])).status).toBe(2);
    }
  });

  test('is not replaced by a report', async () => {
    const shell = new Shell({ kernel: async () => new FakeKernel() });
    execFileSync('mkfifo', [shell.path('pipe')]);
    shell.write('m.ply', model);
    const argv = [
      'run',
      shell.write('r.json', recipe()),
      '--out',
      shell.path('o'),
      '--report',
      shell.path('pipe'),
    ];
    expect(await shell.lissom(argv)).toMatchObject({
      status: 1,
      stderr: expect.stringMatching(
        /^error: cannot-write: .*pipe cannot be written \(a pipe\); nothing was changed\./,
      ),
    });
    expect(shell.files('o')).toEqual([]);
    expect(shell.files()).toEqual(['m.ply', 'o', 'pipe', 'r.json']);
  });
});

test('outputs may have the longest names that the system allows', async () => {
  const shell = new Shell({ kernel: async () => new FakeKernel() });
  shell.write('m.ply', model);
  const file = `${'n'.repeat(251)}.ply`;
  const argv = [
    'run',
    shell.write('r.json', { ...recipe(), outputs: [{ step: 'd', file }] }),
    '--out',
    shell.path('o'),
  ];
  expect(await shell.lissom(argv)).toEqual({ status: 0, stdout: '', stderr: '' });
  expect(shell.files('o')).toEqual([file]);
});

test('a message ends after two thousand characters, never within one', async () => {
  const shell = new Shell();
  const models = Object.fromEntries(Array.from({ length: 500 }, (_, i) => [`𝔪 ${i}`, { builtin: 'bar' }]));
  const { status, stderr } = await shell.lissom(['check', shell.write('r.json', { ...recipe(), models })]);
  expect(status).toBe(2);
  expect(stderr).toMatch(
    /^error: recipe-invalid: steps\[0\]\.model: there is no model or earlier step "m"; .*…\n$/s,
  );
  expect(stderr.length).toBeLessThanOrEqual('error: '.length + 2000 + 1);
  expect(() => encodeURIComponent(stderr)).not.toThrow();
});

describe('a run that does not end', () => {
  /** A kernel that never answers, as a solver deep in its loops. */
  class Silent extends FakeKernel {
    disposed = 0;
    override call = ((_method: unknown, _args: unknown, options: { signal?: AbortSignal } = {}) =>
      new Promise((_, reject) =>
        options.signal?.addEventListener('abort', () => reject(new Error('gone'))),
      )) as FakeKernel['call'];
    dispose(): void {
      this.disposed++;
    }
  }

  const running = (surroundings: ConstructorParameters<typeof Shell>[0], ...more: string[]) => {
    const shell = new Shell(surroundings);
    shell.write('m.ply', model);
    return {
      shell,
      ended: shell.lissom(['run', shell.write('r.json', recipe()), '--out', shell.path('o'), ...more]),
    };
  };

  test('ends with its timeout', async () => {
    const kernel = new Silent();
    const { shell, ended } = running({ kernel: async () => kernel }, '--timeout', '0.05');
    expect(await ended).toEqual({
      status: 1,
      stdout: '',
      stderr: 'error: timed-out: The run took longer than 0.05 s and was ended; nothing was written.\n',
    });
    expect([kernel.disposed, shell.files('o')]).toEqual([1, []]);
  });

  test('ends on Ctrl-C', async () => {
    const kernel = new Silent();
    let stop: () => void = () => {};
    let forgotten = false;
    const onInterrupt = (ask: () => void) => {
      stop = ask;
      return () => {
        forgotten = true;
      };
    };
    const { ended } = running({ kernel: async () => kernel, onInterrupt });
    setTimeout(() => stop(), 50);
    expect(await ended).toMatchObject({
      status: 1,
      stderr: 'error: interrupted: The run was interrupted; nothing was written.\n',
    });
    expect([kernel.disposed, forgotten]).toEqual([1, true]);
  });

  test.each(['0', '-1', 'soon', '1e9', ''])('a timeout of %j is none', async (timeout) => {
    const { ended } = running({}, `--timeout=${timeout}`);
    expect(await ended).toMatchObject({
      status: 1,
      stderr: expect.stringMatching(/^error: usage: --timeout takes /),
    });
  });
});
