// The command line inside the test: a folder of its own, what was printed, and the exit status.

import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { onTestFinished } from 'vitest';
import { cli, type Surroundings } from '../../web/cli/cli';
import { IDENTITY } from '../../web/core/affine';
import type { Model } from '../../web/core/model';
import { readModel, writeModel } from '../../web/io/formats';

export interface Printed {
  readonly status: number;
  readonly stdout: string;
  readonly stderr: string;
}

/** A temporary folder with a shell in it; gone when the test is over. */
export class Shell {
  readonly folder = mkdtempSync(path.join(tmpdir(), 'lissom-'));

  constructor(private readonly surroundings: Surroundings = {}) {
    onTestFinished(() => rmSync(this.folder, { recursive: true, force: true }));
  }

  path(file: string): string {
    return path.join(this.folder, file);
  }

  write(file: string, content: string | Uint8Array | object): string {
    const plain = typeof content === 'string' || content instanceof Uint8Array;
    writeFileSync(this.path(file), plain ? content : JSON.stringify(content));
    return this.path(file);
  }

  read(file: string): string {
    return readFileSync(this.path(file), 'utf8');
  }

  model(file: string): Model {
    return readModel(readFileSync(this.path(file)), file).model;
  }

  /** Names in the folder, or in one within it. */
  files(folder = '.'): string[] {
    const place = this.path(folder);
    return existsSync(place) ? readdirSync(place).sort() : [];
  }

  async lissom(argv: readonly string[], isTTY = false): Promise<Printed> {
    const said = { stdout: '', stderr: '' };
    const stream = (name: keyof typeof said) => ({
      write: (text: string) => {
        said[name] += text;
      },
      isTTY,
    });
    const streams = { stdout: stream('stdout'), stderr: stream('stderr') };
    return { status: await cli(argv, streams, this.surroundings), ...said };
  }

  /** Runs a recipe on `models` (by file name) into the folder `out`, with a report. */
  async run(recipe: object, models: Readonly<Record<string, Model>>): Promise<Printed> {
    for (const [file, model] of Object.entries(models)) this.write(file, writeModel(model, 'ply'));
    const file = this.write('recipe.json', recipe);
    return this.lissom(['run', file, '--out', this.path('out'), '--report', this.path('report.json')]);
  }
}

/** A recipe of one deform step `d` on `m.ply`, writing `o.ply`. */
export const deformRecipe = (handles: readonly object[], step: object = {}, file = 'm.ply') => ({
  lissom: 1,
  models: { m: { file } },
  steps: [{ id: 'd', type: 'deform', model: 'm', handles, ...step }],
  outputs: [{ step: 'd', file: 'o.ply' }],
});

export const region = (vertices: unknown, matrix: readonly number[] = IDENTITY) => ({
  kind: 'region',
  vertices,
  matrix,
});

export const move = (x: number, y: number, z: number): number[] => [...IDENTITY.slice(0, 12), x, y, z, 1];
