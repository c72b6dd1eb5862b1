// Every merged model of the gallery through the real kernel, held to what merging is promised to be.

import { readdirSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import { FolderModels } from '../../web/cli/models';
import type { Model } from '../../web/core/model';
import type { Args, KernelPort } from '../../web/kernel/contract';
import type { Merged } from '../../web/kernel/contract/merge';
import { loadKernel } from '../../web/kernel/node';
import { decodeLink, encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import type { Recipe } from '../../web/recipe/recipe';
import { Runner } from '../../web/run/evaluate';
import type { ReportOf, StepResult } from '../../web/run/results';
import { affine, diagonal, gap, transformed } from '../kernel/shapes';
import { cornersOf, quasiConformal, topologyOf, within } from './surface-measures';
import { crossings } from './triangle-crossings';

const FOLDER = new URL('../../public/gallery/recipes/', import.meta.url);
/** Each with its Euler characteristic: the sum of those of its two parts, cut open. */
const EULER: Readonly<Record<string, number>> = {
  'merge-centaur': 1 + 1,
  'merge-clockwork': -3 + 1, // the key has two holes and one opening
  'merge-dragon': 2 + 0, // two wings, and a body with two openings
  'merge-engine': -2 - 2, // four openings on either side
  'merge-minotaur': 1 + 1,
  'merge-sea-horse': 1 + 1,
};
const NAMES = readdirSync(FOLDER)
  .filter((file) => /^merge-.*\.json$/.test(file))
  .map((file) => file.replace('.json', ''));

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

/** Merged once for all that is asked of it. */
const kept = new Map<string, Promise<Run>>();
function asItIs(name: string): Promise<Run> {
  const running = kept.get(name) ?? run(name);
  kept.set(name, running);
  return running;
}

const recipeOf = (name: string): Recipe => parseRecipe(readFileSync(new URL(`${name}.json`, FOLDER), 'utf8'));
const models = new FolderModels('.');

interface Run {
  readonly model: Model;
  readonly source: Model;
  readonly target: Model;
  readonly merged: Merged;
  readonly report: ReportOf<'merge'>;
}

/**
 * @param moved  what becomes of the source first
 * @param rounds  for the boundary that is sought; 0: the edge of the painted region stays
 */
async function run(name: string, moved: (model: Model) => Model = (model) => model, rounds?: number) {
  const recipe = recipeOf(name);
  const step = recipe.steps[0]!;
  if (step.type !== 'merge') throw new Error(`${name} does not begin with a merge`);
  let merged: Merged | undefined;
  const listening: KernelPort = {
    get epoch() {
      return kernel.epoch;
    },
    call: async (method, args, options) => {
      if (method === 'prepareMerge' && rounds !== undefined)
        Object.assign((args as Args<'prepareMerge'>).optimalBoundary!, { rounds });
      const answer = await kernel.call(method, args, options);
      if (method === 'merge') merged = answer as Merged;
      return answer;
    },
  };
  const load = async (id: string) => {
    const model = await models.load(id, recipe.models[id]!);
    return id === step.source ? moved(model) : model;
  };
  const results = await new Runner({ kernel: listening, models: { load } }).run(recipe);
  const { model, report } = results.get(step.id) as StepResult<'merge'>;
  return {
    model,
    report,
    merged: merged!,
    source: await load(step.source),
    target: await load(step.target),
  } satisfies Run;
}

/** Numbers in [0, 1), the same in every run (Steele and Vigna's mixing, 32 bits). */
function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x9e3779b9) | 0;
    let z = Math.imul(state ^ (state >>> 16), 0x21f0aaad);
    z = Math.imul(z ^ (z >>> 15), 0x735a2d97);
    return ((z ^ (z >>> 15)) >>> 0) / 2 ** 32;
  };
}

/** A turn by a random unit quaternion, a scale from 0.01 to 100 and a shift of that size. */
function similarity(next: () => number): number[] {
  const scale = 10 ** (4 * next() - 2);
  const q = Array.from(
    { length: 4 },
    () => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next()),
  );
  const [w, x, y, z] = q.map((c) => c / Math.hypot(...q)) as [number, number, number, number];
  const turn = [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
  const [a, b, c] = turn.map((row) => row.map((m) => scale * m)) as [number[], number[], number[]];
  const shift = [0, 1, 2].map(() => scale * (6 * next() - 3));
  return affine(
    [a, b, c] as unknown as Parameters<typeof affine>[0],
    shift as unknown as Parameters<typeof affine>[1],
  );
}

/** 95 % of the source's faces are stretched at most so much more one way than the other. */
function distortion({ source, model, merged }: Run): number {
  const at = ({ positions }: Model, v: number) => [...positions.subarray(3 * v, 3 * v + 3)];
  const whole = new Set(merged.source.faces);
  const ratios = cornersOf(source)
    .filter((_, face) => whole.has(face))
    .map((corners) =>
      quasiConformal(
        corners.map((v) => at(source, v)),
        corners.map((v) => at(model, merged.source.resultOfVertex[v]!)),
      ),
    )
    .sort((a, b) => a - b);
  return ratios[Math.floor(0.95 * ratios.length)]!;
}

describe.each(NAMES)('%s', (name) => {
  let made: Run;
  beforeAll(async () => {
    made = await asItIs(name);
  });

  test('is one closed, consistently oriented surface of the Euler characteristic predicted', () => {
    expect(topologyOf(made.model)).toEqual({ twice: 0, open: 0, pieces: 1, euler: EULER[name] });
    expect(made.report.eulerCharacteristic).toBe(EULER[name]);
  });

  test('is no more bent along its seam than its parts are elsewhere, and has no thin faces there', () => {
    const { seam } = made.report;
    expect(seam.highDihedral).toBeLessThanOrEqual(seam.ownHighDihedral);
    expect(seam.leastAngle).toBeGreaterThan(1);
  });

  test('does not pass through itself at the seam', () => {
    const near = within(
      made.model,
      made.merged.seams.flatMap((seam) => [...seam]),
      2,
    );
    expect(crossings(made.model, near)).toEqual([]);
  });

  test('is the same wherever its source stands, however it is turned and however large it is', async () => {
    const next = numbers(4);
    for (let k = 0; k < 20; k++) {
      const map = similarity(next);
      const other = await run(name, (model) => ({ ...model, positions: transformed(model.positions, map) }));
      expect(other.model.faceVertices).toEqual(made.model.faceVertices);
      expect(gap(other.model.positions, made.model.positions)).toBeLessThan(
        1e-6 * diagonal(made.target.positions),
      );
    }
  });

  test('fits into a link', () => {
    const link = encodeLink(recipeOf(name), 'http://localhost/');
    expect(decodeLink(link)).toEqual(recipeOf(name));
  });
});

const sought = NAMES.filter((name) => {
  const step = recipeOf(name).steps[0]!;
  return step.type === 'merge' && step.optimalBoundary !== undefined;
});

test('there are boundaries to be found in the gallery', () => expect(sought.length).toBeGreaterThan(1));

describe.each(sought)('the boundary found for %s', (name) => {
  test('has at most 0.8 of the energy of the edge painted, which never rose on the way', async () => {
    const energy = (await asItIs(name)).report.energy!;
    for (const [k, value] of energy.entries()) if (k > 0) expect(value).toBeLessThanOrEqual(energy[k - 1]!);
    expect(energy.at(-1)).toBeLessThanOrEqual(0.8 * energy[0]!);
  });

  test('distorts the source less than the edge painted does', async () => {
    expect(distortion(await asItIs(name))).toBeLessThan(distortion(await run(name, (model) => model, 0)));
  });
});
