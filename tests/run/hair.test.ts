import { beforeAll, beforeEach, describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import type { Args, CallOptions, KernelPort, Method, Result } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { newHairStep } from '../../web/recipe/steps/hair';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';
import { PREVIEW_STRANDS } from '../../web/run/steps/hair';
import type { ModelSource } from '../../web/run/types';
import { combedDown, egg, scalpOf, skin } from '../kernel/hair-shapes';

const shape = egg();
const plain: Model = { name: 'egg', ...shape };
const MODELS: Readonly<Record<string, Model>> = {
  egg: { ...plain, vertexSets: { scalp: scalpOf(shape) } },
  bald: plain,
};
const models: ModelSource = {
  load: async (_, ref) => MODELS['builtin' in ref ? ref.builtin : '']!,
};

/** The real kernel, and how often each of its methods was called. */
class CountingKernel implements KernelPort {
  calls: Record<string, number> = {};
  constructor(private readonly kernel: KernelPort) {}
  get epoch(): number {
    return this.kernel.epoch;
  }
  call<M extends Method>(method: M, args: Args<M>, options?: CallOptions): Promise<Result<M>> {
    this.calls[method] = (this.calls[method] ?? 0) + 1;
    return this.kernel.call(method, args, options);
  }
  take(): Record<string, number> {
    const { release: _, ...calls } = this.calls;
    this.calls = {};
    return calls;
  }
}

let loaded: KernelPort;
beforeAll(async () => {
  loaded = await loadKernel();
});
let kernel: CountingKernel;
let runner: Runner;
beforeEach(() => {
  kernel = new CountingKernel(loaded);
  runner = new Runner({ kernel, models });
});

const streams = combedDown().map((points) => ({ points }));
const recipeOf = (step: object, model = 'egg') =>
  parseRecipe({
    lissom: 1,
    models: { head: { builtin: model } },
    steps: [{ id: 'style', type: 'hair', model: 'head', grid: { resolution: 16 }, streams, ...step }],
  });
const run = async (step: object, options = {}, model = 'egg') =>
  (await runner.run(recipeOf(step, model), options)).get('style') as StepResult<'hair'>;

test('a handful of streams gives a head of hair, its head beside it, and the figures of the report', async () => {
  const { model, strands, report } = await run({ strands: { count: 500 } });
  expect(model).toBe(MODELS.egg);
  expect(strands!.offsets).toHaveLength(501);
  expect(strands!.origin.every((x) => Math.abs(x) < 1e-9)).toBe(true);
  expect(strands!.look).toMatchObject({ colorVariation: 0.2, taper: 0.35 });
  expect(strands!.look.color).toMatch(/^#[0-9a-f]{6}$/);
  // 0.08 mm on 24 cm, twice that for so few.
  expect(strands!.look.thickness).toBeCloseTo(0.00016, 7);
  expect(report).toMatchObject({
    id: 'style',
    type: 'hair',
    vertices: shape.positions.length / 3,
    strands: 500,
    insideHead: 0,
    gathered: [],
    warnings: [],
  });
  expect(report.constraints).toBeGreaterThan(100);
  expect(Math.max(...report.grid)).toBe(16);
  expect(Object.keys(report.seconds)).toEqual(['prepare', 'update', 'field', 'grow']);
  expect(report.peakBytes).toBeGreaterThan(1e6);
});

describe('nothing is computed twice', () => {
  test('a stroke edit styles and grows; detail alone only grows; names and hiding do nothing', async () => {
    await run({ strands: { count: 50 } });
    expect(kernel.take()).toEqual({ openModel: 1, openHair: 1, styleHair: 1, growHair: 1 });
    await run({ strands: { count: 50 }, streams: streams.slice(1) });
    expect(kernel.take()).toEqual({ styleHair: 1, growHair: 1 });
    await run({ strands: { count: 50 }, streams: streams.slice(1), detail: { curl: 1 } });
    expect(kernel.take()).toEqual({ growHair: 1 });
    const named = streams.slice(1).map((stream) => ({ ...stream, name: 'lock', hidden: true }));
    await run({ strands: { count: 50 }, streams: named, detail: { curl: 1 } });
    expect(kernel.take()).toEqual({});
  });

  test('a preview is a prefix of what follows it', async () => {
    const preview = (await run({ strands: { count: 6000 } }, { settle: false })).strands!;
    const all = (await run({ strands: { count: 6000 } })).strands!;
    expect(preview.offsets).toHaveLength(PREVIEW_STRANDS + 1);
    expect(all.points.slice(0, preview.points.length)).toEqual(preview.points);
  });

  test('results depend on the recipe alone, not on what was drawn before', async () => {
    await run({ strands: { count: 40 }, streams: streams.slice(3) });
    const after = (await run({ strands: { count: 40 } })).strands!;
    const fresh = (
      await new Runner({ kernel: await loadKernel(), models }).run(recipeOf({ strands: { count: 40 } }))
    ).get('style')!.strands!;
    expect(after.points).toEqual(fresh.points);
  });
});

test('the scalp may be the step’s own, lengths be painted and colours chosen', async () => {
  const all = Array.from({ length: shape.positions.length / 3 }, (_, v) => v);
  const top = all.filter((v) => shape.positions[3 * v + 1]! > 0.05);
  const { strands } = await run(
    {
      scalp: top,
      strands: { count: 200 },
      length: {
        max: 0.1,
        map: [
          { vertices: 'all', factor: 0 },
          { vertices: top, factor: 1 },
        ],
      },
      material: { color: '#AA5500', thickness: 0.001 },
    },
    {},
    'bald',
  );
  expect(strands!.look).toMatchObject({ color: '#aa5500', thickness: 0.001 });
  for (let i = 0; i < 200; i++)
    expect(strands!.points[3 * strands!.offsets[i]! + 1]! + strands!.origin[1]).toBeGreaterThan(0.05);
});

describe('bad input is a sentence or a sensible result', () => {
  test.each<[what: string, step: object, expected: RegExp]>([
    ['ten million strands', { strands: { count: 10_000_000 } }, /strands\.count.*0 to 1,000,000/],
    ['a grid too fine', { grid: { resolution: 300 } }, /resolution.*16 to 96/],
    ['a field nobody knows', { frizziness: 1 }, /frizziness/],
    [
      'a point of two numbers',
      { streams: [{ points: [[0, 1]] }] },
      /streams\[0\]\.points\[0\].*a number, found nothing/,
    ],
    ['a colour that is none', { material: { color: 'brown' } }, /#5a3825/],
  ])('%s', (_, step, expected) => {
    expect(() => recipeOf(step)).toThrow(expected);
  });

  test('a head without a scalp', async () => {
    await expect(run({}, {}, 'bald')).rejects.toMatchObject({
      code: 'scalp-missing',
      place: 'steps[0] (style)',
      message: expect.stringMatching(/Paint a scalp/),
    });
  });

  test('a scalp vertex that is not there', async () => {
    await expect(run({ scalp: [0, 99_999] })).rejects.toMatchObject({ code: 'index-out-of-range' });
  });

  test.each<[what: string, step: object, codes: string[], strands: number]>([
    ['no strands', { strands: { count: 0 } }, [], 0],
    ['nothing drawn yet', { streams: [], strands: { count: 9 } }, ['style-empty'], 0],
    [
      'a stroke of one point',
      { streams: [...streams, { points: [[0, 0.13, 0]] }], strands: { count: 9 } },
      ['stroke-too-short'],
      9,
    ],
    [
      'a stroke off the head',
      {
        streams: [
          ...streams,
          {
            points: [
              [8, 8, 8],
              [9, 9, 9],
            ],
          },
        ],
        strands: { count: 9 },
      },
      ['stroke-outside'],
      9,
    ],
    [
      'streams that contradict each other',
      {
        streams: [streams[0], { points: streams[0]!.points.toReversed() }, streams[4]],
        strands: { count: 9 },
      },
      [],
      9,
    ],
    [
      'a stroke across itself',
      {
        streams: [
          {
            points: [
              skin([0, 1, 0], 0.01),
              skin([1, 1, 1], 0.01),
              skin([1, 1, 0], 0.01),
              skin([0, 1, 1], 0.01),
            ],
          },
        ],
        strands: { count: 9 },
      },
      [],
      9,
    ],
    [
      'a ponytail half drawn',
      {
        ponytails: [
          {
            spine: [
              [0, 0, -0.11],
              [0, 0, -0.2],
            ],
          },
        ],
        strands: { count: 9 },
      },
      ['ponytail-incomplete'],
      9,
    ],
  ])('%s', async (_, step, codes, count) => {
    const { strands, report } = await run(step);
    expect(report.warnings.map(({ code }) => code)).toEqual(codes);
    expect(strands!.offsets).toHaveLength(count + 1);
    expect(report).toMatchObject({ insideHead: 0, shortStrands: 0 });
  });
});

test('a new hair step is complete and empty', () => {
  expect(newHairStep('hair 1', 'head')).toMatchObject({
    type: 'hair',
    grid: { resolution: 48 },
    strands: { count: 30_000, seed: 1, step: 0.5 },
    streams: [],
    detail: { clump: 0.4, curl: 0 },
  });
});
