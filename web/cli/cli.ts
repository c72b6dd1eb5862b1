// The `lissom` command: recipes without a browser.

import path from 'node:path';
import { version } from '../../package.json';
import { LissomError } from '../core/errors';
import type { ModelFormat } from '../core/model';
import { writeModel } from '../io/formats';
import { groomFile } from '../io/strands/groom-file';
import type { StrandFormat } from '../io/strands/options';
import type { KernelPort } from '../kernel/contract';
import { extensionOf } from '../recipe/cross-checks';
import { formatRecipe } from '../recipe/format';
import { decodeLink, encodeLink } from '../recipe/link/link';
import { parseRecipe } from '../recipe/parse';
import { oneLine } from '../recipe/problem';
import type { Recipe } from '../recipe/recipe';
import { Runner } from '../run/evaluate';
import { plan } from '../run/plan';
import { resultNamed, type StepResult } from '../run/results';
import { PlacedError } from '../run/types';
import { readable, writeAll } from './files';
import { FolderModels } from './models';
import { Progress } from './progress';
import { reportOf } from './report';
import type { Streams } from './streams';
import { type Command, commandOf, USAGE } from './usage';

/** What a command needs beside its arguments; tests bring their own. */
export interface Surroundings {
  readonly kernel?: () => Promise<KernelPort>;
}

/** Only `run` needs the solver; the other commands do not wait for it. */
const realKernel = async (): Promise<KernelPort> => (await import('../kernel/node')).loadKernel();

/** @returns the exit status: 0 done, 2 the recipe, link or a model is wrong, 1 anything else */
export async function cli(
  argv: readonly string[],
  streams: Streams,
  { kernel = realKernel }: Surroundings = {},
): Promise<number> {
  try {
    await obey(commandOf(argv), streams, kernel);
    return 0;
  } catch (error) {
    streams.stderr.write(`error: ${oneLine(described(error))}\n`);
    return error instanceof LissomError && error.fault === 'input' ? 2 : 1;
  }
}

async function obey(command: Command, streams: Streams, kernel: () => Promise<KernelPort>): Promise<void> {
  const print = (text: string) => streams.stdout.write(text);
  switch (command.name) {
    case 'help':
      return void print(USAGE);
    case 'version':
      return void print(`${version}\n`);
    case 'run':
      return run(command, streams, kernel);
    case 'check':
      return check(command.recipe, streams);
    case 'link':
      return void print(`${encodeLink(await recipeIn(command.recipe), command.app)}\n`);
    case 'unlink':
      return void print(formatRecipe(decodeLink(command.link)));
  }
}

async function run(
  { recipe: file, out, report }: Extract<Command, { name: 'run' }>,
  { stderr }: Streams,
  kernel: () => Promise<KernelPort>,
): Promise<void> {
  const recipe = await recipeIn(file);
  const models = new FolderModels(path.dirname(file));
  const progress = new Progress(stderr);
  try {
    const runner = new Runner({ kernel: await kernel(), models });
    const results = await runner.run(recipe, {
      onProgress: (fraction, step) => progress.update(fraction, step),
    });
    const files = outputsOf(recipe, results, out);
    if (report !== undefined) files.set(path.resolve(report), reportOf(recipe, results, models.notes));
    await writeAll(files);
    progress.done(results);
  } finally {
    progress.clear();
  }
}

async function check(file: string, { stderr }: Streams): Promise<void> {
  const recipe = await recipeIn(file);
  await plan(recipe, new FolderModels(path.dirname(file)));
  const count = (n: number, what: string) => `${n} ${what}${n === 1 ? '' : 's'}`;
  if (stderr.isTTY)
    stderr.write(
      `${file} is right: ${count(recipe.steps.length, 'step')}, ${count(recipe.outputs.length, 'output')}\n`,
    );
}

async function recipeIn(file: string): Promise<Recipe> {
  return parseRecipe(new TextDecoder().decode(await readable('recipe-not-found', file)));
}

function outputsOf(
  recipe: Recipe,
  results: ReadonlyMap<string, StepResult>,
  folder: string,
): Map<string, Uint8Array | string> {
  const files = new Map<string, Uint8Array | string>();
  for (const { step, file } of recipe.outputs) {
    const { model, strands } = resultNamed(recipe, results, step);
    const extension = extensionOf(file);
    const bytes = strands
      ? groomFile(step, strands, model, extension as StrandFormat)
      : writeModel(model, extension as ModelFormat);
    files.set(path.resolve(folder, file), bytes);
  }
  return files;
}

function described(error: unknown): string {
  if (error instanceof PlacedError) return `${error.code}: ${error.place}: ${error.message}`;
  if (error instanceof LissomError) return `${error.code}: ${error.message}`;
  return `unexpected: ${error instanceof Error ? error.message : String(error)}`;
}
