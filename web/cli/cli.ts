// The `lissom` command: recipes without a browser.

import path from 'node:path';
import { version } from '../../package.json';
import { LissomError } from '../core/errors';
import type { ModelFormat } from '../core/model';
import type { Skin } from '../core/skin';
import { writeModel } from '../io/formats';
import { writeGltfMorphs } from '../io/gltf-morphs';
import { writeSkinnedGltf } from '../io/gltf-skin';
import { groomFile } from '../io/strands/groom-file';
import type { StrandFormat } from '../io/strands/options';
import type { KernelPort } from '../kernel/contract';
import { extensionOf } from '../recipe/cross-checks';
import { formatRecipe } from '../recipe/format';
import { decodeLink, encodeLink } from '../recipe/link/link';
import { parseRecipe } from '../recipe/parse';
import { oneLine } from '../recipe/problem';
import type { Recipe } from '../recipe/recipe';
import { producerOf } from '../recipe/references';
import { Runner } from '../run/evaluate';
import { plan } from '../run/plan';
import { resultNamed, type StepResult } from '../run/results';
import { PlacedError } from '../run/types';
import { readable, writeAll } from './files';
import { FolderModels } from './models';
import { Progress } from './progress';
import { reportOf } from './report';
import { stopAfter } from './stop';
import type { Streams } from './streams';
import { type Command, commandOf, USAGE } from './usage';

/** What a command needs beside its arguments; tests bring their own. */
export interface Surroundings {
  /** A kernel for one run; one that has to be ended by hand is. */
  readonly kernel?: () => Promise<KernelPort & { dispose?(): void }>;
  /** Calls back when the user wants a run to end; returns what forgets it. */
  readonly onInterrupt?: (stop: () => void) => () => void;
}

/** Longest message, in characters: names and lists in it are anybody's. */
const LONGEST = 2000;

/** Only `run` needs the solver; the other commands do not wait for it. */
const realKernel = async (): Promise<KernelPort> => (await import('../kernel/node')).loadKernel();

/** @returns the exit status: 0 done, 2 the recipe, link or a model is wrong, 1 anything else */
export async function cli(
  argv: readonly string[],
  streams: Streams,
  surroundings: Surroundings = {},
): Promise<number> {
  try {
    await obey(commandOf(argv), streams, surroundings);
    return 0;
  } catch (error) {
    streams.stderr.write(`error: ${cutShort(oneLine(described(error)))}\n`);
    return isInputsFault(error) ? 2 : 1;
  }
}

/** Numbers that could not be solved are the recipe's and the models'. */
const isInputsFault = (error: unknown): boolean =>
  error instanceof LissomError && (error.fault === 'input' || error.fault === 'solver');

/** Never in the middle of a character. */
const cutShort = (text: string): string =>
  text.length <= LONGEST ? text : `${text.slice(0, LONGEST - 1).replace(/[\uD800-\uDBFF]$/, '')}…`;

async function obey(command: Command, streams: Streams, surroundings: Surroundings): Promise<void> {
  const print = (text: string) => streams.stdout.write(text);
  switch (command.name) {
    case 'help':
      return void print(USAGE);
    case 'version':
      return void print(`${version}\n`);
    case 'run':
      return run(command, streams, surroundings);
    case 'check':
      return check(command, streams);
    case 'link':
      return void print(`${encodeLink(await recipeIn(command.recipe), command.app)}\n`);
    case 'unlink':
      return void print(formatRecipe(decodeLink(command.link)));
  }
}

async function run(
  { recipe: file, out, report, timeout, allowOutside }: Extract<Command, { name: 'run' }>,
  { stderr }: Streams,
  { kernel = realKernel, onInterrupt = () => () => {} }: Surroundings,
): Promise<void> {
  const stop = stopAfter(timeout, onInterrupt);
  const progress = new Progress(stderr);
  let solver: Awaited<ReturnType<typeof kernel>> | undefined;
  try {
    const recipe = await recipeIn(file);
    const models = new FolderModels(path.dirname(file), { allowOutside });
    solver = await kernel();
    const runner = new Runner({ kernel: solver, models });
    const results = await runner.run(recipe, {
      signal: stop.signal,
      onProgress: (fraction, step) => progress.update(fraction, step),
      onPreparation: (preparation, step) => progress.preparing(preparation, step),
    });
    const files = await outputsOf(recipe, results, out, (step) =>
      runner.ask(recipe, step, 'skin', {}, { signal: stop.signal }),
    );
    if (report !== undefined) files.set(path.resolve(report), reportOf(recipe, results, models.notes));
    stop.check();
    await writeAll(files);
    progress.done(results);
  } catch (error) {
    throw stop.reason(error);
  } finally {
    stop.release();
    solver?.dispose?.();
    progress.clear();
  }
}

async function check(
  { recipe: file, allowOutside }: Extract<Command, { name: 'check' }>,
  { stderr }: Streams,
): Promise<void> {
  const recipe = await recipeIn(file);
  await plan(recipe, new FolderModels(path.dirname(file), { allowOutside }));
  const count = (n: number, what: string) => `${n} ${what}${n === 1 ? '' : 's'}`;
  if (stderr.isTTY)
    stderr.write(
      `${file} is right: ${count(recipe.steps.length, 'step')}, ${count(recipe.outputs.length, 'output')}\n`,
    );
}

async function recipeIn(file: string): Promise<Recipe> {
  return parseRecipe(new TextDecoder().decode(await readable('recipe-not-found', file, 'recipe')));
}

async function outputsOf(
  recipe: Recipe,
  results: ReadonlyMap<string, StepResult>,
  folder: string,
  skinOf: (step: string) => Promise<Skin>,
): Promise<Map<string, Uint8Array | string>> {
  const files = new Map<string, Uint8Array | string>();
  for (const { step, file, skin, morphs } of recipe.outputs) {
    const { model, strands } = resultNamed(recipe, results, step);
    const extension = extensionOf(file);
    const write = async () => {
      if (strands) return groomFile(step, strands, model, extension as StrandFormat);
      if (morphs) {
        const { models = {} } = results.get(producerOf(recipe, step)!.id)!;
        const others = Object.values(models).filter((other) => other !== model);
        return writeGltfMorphs(model, others, extension as 'glb' | 'gltf');
      }
      if (!skin) return writeModel(model, extension as ModelFormat);
      const [rest] = results.get(step)!.inputs;
      return writeSkinnedGltf(rest!.model, await skinOf(step), extension as 'glb' | 'gltf');
    };
    files.set(path.resolve(folder, file), await write());
  }
  return files;
}

function described(error: unknown): string {
  if (error instanceof PlacedError) return `${error.code}: ${error.place}: ${error.message}`;
  if (error instanceof LissomError) return `${error.code}: ${error.message}`;
  return `unexpected: ${error instanceof Error ? error.message : String(error)}`;
}
