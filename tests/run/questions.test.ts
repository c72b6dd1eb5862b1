// What may be asked of steps beside their results, with a worker that dies on the way.

import { beforeAll, beforeEach, describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import type { Args, CallOptions, KernelPort, Method, Result } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import type { ModelSource } from '../../web/run/types';
import { combedDown, egg, scalpOf } from '../kernel/hair-shapes';
import { dome, tube } from '../kernel/tubes';

/** The real kernel, which dies just before it would be asked for a certain thing. */
class MortalKernel implements KernelPort {
  diesBefore: Method | undefined;
  deaths = 0;
  constructor(private readonly kernel: KernelPort) {}

  get epoch(): number {
    return this.kernel.epoch;
  }

  async call<M extends Method>(method: M, args: Args<M>, options?: CallOptions): Promise<Result<M>> {
    if (method === this.diesBefore) {
      this.diesBefore = undefined;
      await this.die();
    }
    return this.kernel.call(method, args, options);
  }

  /** What it cannot read is no refusal, so the kernel is replaced. */
  async die(): Promise<void> {
    const { epoch } = this;
    await this.kernel.call('openModel', null as never).catch(() => {});
    expect(this.epoch).toBe(epoch + 1);
    this.deaths++;
  }
}

const shape = egg();
const cap = (low: number) =>
  Array.from({ length: dish.positions.length / 3 }, (_, v) => v).filter(
    (v) => dish.positions[3 * v + 1]! > low,
  );
const dish: Model = { name: 'dish', ...tube(14, 20, dome) };
const MODELS: Readonly<Record<string, Model>> = {
  egg: { name: 'egg', ...shape, vertexSets: { scalp: scalpOf(shape) } },
  dish,
};
const recipe = parseRecipe({
  lissom: 1,
  models: Object.fromEntries(Object.keys(MODELS).map((name) => [name, { builtin: name }])),
  steps: [
    {
      id: 'up',
      type: 'deform',
      model: 'egg',
      handles: [{ kind: 'point', vertices: [0], position: [0, 0, 0] }],
    },
    {
      id: 'style',
      type: 'hair',
      model: 'up',
      grid: { resolution: 16 },
      streams: combedDown().map((points) => ({ points })),
      strands: { count: 20 },
    },
    {
      id: 'joint',
      type: 'merge',
      source: 'dish',
      target: 'dish',
      optimalBoundary: { sourceRegion: cap(0.6), feature: cap(1.5), targetRegion: cap(0.4) },
    },
  ],
});

const models: ModelSource = { load: async (name) => MODELS[name]! };
let loaded: KernelPort;
beforeAll(async () => {
  loaded = await loadKernel();
});
let kernel: MortalKernel;
let runner: Runner;
beforeEach(() => {
  kernel = new MortalKernel(loaded);
  runner = new Runner({ kernel, models });
});

const ASKED = {
  field: () => runner.ask(recipe, 'style', 'field', { stride: 3 }),
  maps: () => runner.ask(recipe, 'joint', 'maps', {}),
  loopsAround: () =>
    runner.ask(recipe, 'joint', 'loopsAround', { side: 'source', vertices: Uint32Array.from(cap(1)) }),
  strands: async () => (await runner.run(recipe, { until: 'style' })).get('style')!.strands,
  opened: async () => (await runner.opened(recipe, 'up')).opened.welded,
  inputs: async () => (await runner.inputs(recipe, 'style')).map(({ opened }) => opened.welded),
  measured: async () =>
    (await runner.run(recipe, { until: 'up', measure: true })).get('up')!.measured?.worstStretch,
} as const;

const answers = new Map<keyof typeof ASKED, Promise<unknown>>();

/** The answer where nobody dies, asked for once. */
async function undisturbed(question: keyof typeof ASKED): Promise<unknown> {
  const known = answers.get(question);
  if (known) return known;
  runner = new Runner({ kernel: loaded, models });
  const answer = ASKED[question]();
  answers.set(question, answer);
  expect(await answer).toBeDefined();
  return answer;
}

/** Places on the way to an answer, the first of all to the last. */
const DEATHS: readonly [question: keyof typeof ASKED, before: Method][] = [
  ['field', 'openModel'],
  ['field', 'prepareDeform'],
  ['field', 'openHair'],
  ['field', 'styleHair'],
  ['field', 'hairField'],
  ['field', 'hairConstraints'],
  ['strands', 'growHair'],
  ['maps', 'openModel'],
  ['maps', 'mapRegions'],
  ['loopsAround', 'loopsAround'],
  ['opened', 'deform'],
  ['inputs', 'deform'],
  ['measured', 'measure'],
];

describe('a worker that dies costs time, not the answer', () => {
  test.each(DEATHS)('%s, just before %s', async (question, before) => {
    kernel.diesBefore = before;
    const answer = await ASKED[question]();
    expect(kernel.deaths).toBe(1);
    expect(answer).toEqual(await undisturbed(question));
  });

  test.each(['field', 'maps', 'loopsAround', 'opened', 'inputs'] as const)(
    '%s, asked again after it died in between',
    async (question) => {
      await ASKED[question]();
      await kernel.die();
      expect(await ASKED[question]()).toEqual(await undisturbed(question));
    },
  );
});

test('a question is asked of the step’s own inputs and nothing else is computed for it', async () => {
  const field = await runner.ask(recipe, 'style', 'field', { stride: 2 });
  expect(field.places.length).toBeGreaterThan(0);
  expect(field.vectors).toHaveLength(field.places.length);
  expect(field.constraints.places.length).toBeGreaterThan(0);
  const { source, placement } = await runner.ask(recipe, 'joint', 'maps', {});
  expect(source.points).toHaveLength(2 * source.vertices.length);
  expect(placement.scale).toBeGreaterThan(0);
});

test('a step is only asked what its type can tell', async () => {
  await expect(runner.ask(recipe, 'joint', 'field', { stride: 2 })).rejects.toMatchObject({
    code: 'step-not-found',
    message: 'The merge step "joint" knows no field.',
  });
  await expect(runner.ask(recipe, 'nowhere', 'maps', {})).rejects.toMatchObject({ code: 'step-not-found' });
  const over = AbortSignal.abort();
  await expect(runner.ask(recipe, 'joint', 'maps', {}, { signal: over })).rejects.toMatchObject({
    code: 'cancelled',
  });
});
