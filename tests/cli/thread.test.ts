// The command as it is shipped, its kernel in a thread: a solver deep in its loops is ended all the same.

import { spawn } from 'node:child_process';
import { copyFileSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { cli } from '../../web/cli/cli';
import type { Model } from '../../web/core/model';
import { readModel, writeModel } from '../../web/io/formats';
import { combedDown, egg, scalpOf } from '../kernel/hair-shapes';
import { bowl, dome, tube } from '../kernel/tubes';
import { gap, sheet } from './shapes';
import { deformRecipe, move, region } from './shell';

const root = fileURLToPath(new URL('../..', import.meta.url));

type Place = (file: string) => string;

const models = (at: Place, named: Readonly<Record<string, Model>>): void => {
  for (const [file, model] of Object.entries(named)) writeFileSync(at(file), writeModel(model, 'ply'));
};
const recipe = (at: Place, content: object): void => writeFileSync(at('r.json'), JSON.stringify(content));

function longMerge(at: Place): void {
  const around = 500;
  models(at, {
    's.ply': { name: 's', ...tube(500, around, dome) },
    't.ply': { name: 't', ...tube(500, around, bowl, false) },
  });
  const loop = Array.from({ length: around }, (_, v) => v);
  const boundary = { source: loop, target: loop, keys: [[0, 0]] };
  recipe(at, {
    lissom: 1,
    models: { s: { file: 's.ply' }, t: { file: 't.ply' } },
    steps: [{ id: 'm', type: 'merge', source: 's', target: 't', boundaries: [boundary] }],
    outputs: [{ step: 'm', file: 'o.ply' }],
  });
}

function longGrowth(at: Place): void {
  const shape = egg();
  models(at, { 'h.ply': { name: 'h', ...shape } });
  recipe(at, {
    lissom: 1,
    models: { h: { file: 'h.ply' } },
    steps: [
      {
        id: 'hair',
        type: 'hair',
        model: 'h',
        scalp: [...scalpOf(shape)],
        grid: { resolution: 16 },
        streams: combedDown().map((points) => ({ points })),
        strands: { count: 500_000 },
      },
    ],
    outputs: [{ step: 'hair', file: 'o.ply' }],
  });
}

function longFactorization(at: Place): void {
  const side = 500;
  models(at, { 'm.ply': sheet(side, side) });
  const last = (side + 1) ** 2 - 1;
  recipe(at, deformRecipe([region({ ranges: [[0, side]] }), region([last], move(0, 0, 0.2))]));
}

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

  // Whatever the kernel is at: cutting and factoring two models, growing strands, factoring a region. Each takes the
  // kernel ten times as long as the run is given.
  test.each([
    ['a merge', longMerge],
    ['the growth of hair', longGrowth],
    ['a factorization', longFactorization],
  ])('ends %s with its timeout', async (what, write) => {
    write(at);
    const seconds = 4;
    const started = performance.now();
    const ended = await lissom(['run', 'r.json', '--out', 'q', '--timeout', `${seconds}`]);
    const late = (performance.now() - started) / 1000 - seconds;
    console.log(
      `${what}: the process was gone ${late.toFixed(2)} s after its timeout, its own start included`,
    );
    expect(ended).toEqual({
      code: 1,
      stderr: `error: timed-out: The run took longer than ${seconds} s and was ended; nothing was written.\n`,
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
