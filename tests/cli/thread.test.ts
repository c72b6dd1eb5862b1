// The command as it is shipped, its kernel in a thread: a solver deep in its loops is ended all the same.

import { spawn } from 'node:child_process';
import { copyFileSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { cli } from '../../web/cli/cli';
import { readModel, writeModel } from '../../web/io/formats';
import { gap, sheet } from './shapes';
import { deformRecipe, move, region } from './shell';

const root = fileURLToPath(new URL('../..', import.meta.url));

describe('the command line as one file', () => {
  let folder = '';
  const at = (name: string) => path.join(folder, name);

  beforeAll(async () => {
    folder = mkdtempSync(path.join(tmpdir(), 'lissom-cli-'));
    const outDir = at('bin');
    await build({
      root,
      configFile: path.join(root, 'vite.cli.config.ts'),
      logLevel: 'silent',
      build: { outDir },
    });
    copyFileSync(path.join(root, 'wasm/dist/kernel.wasm'), at('bin/kernel.wasm'));
  });
  afterAll(() => rmSync(folder, { recursive: true, force: true }));

  /** @param signal  sent after a while */
  function lissom(
    argv: readonly string[],
    signal?: NodeJS.Signals,
  ): Promise<{ code: number | null; stderr: string }> {
    const child = spawn(process.execPath, [at('bin/lissom.mjs'), ...argv], { cwd: folder });
    let stderr = '';
    child.stderr.on('data', (text) => {
      stderr += text;
    });
    if (signal) setTimeout(() => child.kill(signal), 6000);
    return new Promise((resolve) => child.on('close', (code) => resolve({ code, stderr })));
  }

  function prepare(columns: number, iterations: number): void {
    const model = sheet(columns, columns);
    const last = (columns + 1) ** 2 - 1;
    writeFileSync(at('m.ply'), writeModel(model, 'ply'));
    const handles = [region({ ranges: [[0, columns]] }), region([last], move(0, 0, 0.2))];
    const recipe = deformRecipe(handles, { method: 'iterative', options: { iterations } });
    writeFileSync(at('r.json'), JSON.stringify(recipe));
  }

  test('gives what the kernel gives without a thread', async () => {
    prepare(8, 3);
    expect(await lissom(['run', 'r.json', '--out', 'o'])).toEqual({ code: 0, stderr: '' });
    const streams = { stdout: { write: () => {} }, stderr: { write: () => {} } };
    expect(await cli(['run', at('r.json'), '--out', at('p')], streams)).toBe(0);
    const positions = (file: string) => readModel(readFileSync(at(file)), file).model.positions;
    expect(gap(positions('o/o.ply'), positions('p/o.ply'))).toBe(0);
  });

  // Minutes of work: neither could end by itself within the time a test has.
  test('ends with its timeout, with nothing written', async () => {
    prepare(400, 100);
    expect(await lissom(['run', 'r.json', '--out', 'q', '--timeout', '2'])).toEqual({
      code: 1,
      stderr: 'error: timed-out: The run took longer than 2 s and was ended; nothing was written.\n',
    });
    expect(readdirSync(folder)).not.toContain('q');
  });

  test('ends on Ctrl-C, with nothing written', async () => {
    prepare(400, 100);
    expect(await lissom(['run', 'r.json', '--out', 'q'], 'SIGINT')).toEqual({
      code: 1,
      stderr: 'error: interrupted: The run was interrupted; nothing was written.\n',
    });
    expect(readdirSync(folder)).not.toContain('q');
  });
});
