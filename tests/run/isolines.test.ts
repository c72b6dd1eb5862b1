// Deform steps by the isoline method, through the real kernel.

import { beforeAll, describe, expect, test } from 'vitest';
import type { LissomError } from '../../web/core/errors';
import type { KernelPort, Method, Result } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';
import { bar, gap, verticesWhere } from '../kernel/shapes';

const MODEL = { name: 'bar', ...bar(24, 5) };
const END = [...verticesWhere(MODEL, (x) => x > 22.5)];
const moved = (x: number, y: number, z: number) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
const handle = (vertices: readonly number[], matrix = moved(0, 0, 0)) => ({
  kind: 'region',
  vertices,
  matrix,
});
const HELD = handle([...verticesWhere(MODEL, (x) => x < 1.5)]);

const recipe = (handles: readonly object[], options: object = {}, more: object = {}) =>
  parseRecipe({
    lissom: 1,
    models: { bar: { builtin: 'bar' } },
    steps: [{ id: 'd', type: 'deform', model: 'bar', method: 'isolines', handles, options, ...more }],
  });

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});
const runner = () => new Runner({ kernel, models: { load: async () => MODEL } });
const run = async (...args: Parameters<typeof recipe>) =>
  (await runner().run(recipe(...args))).get('d') as StepResult<'deform'>;

test('the report says how small the problem was, and handles are met', async () => {
  const { model, report } = await run([HELD, handle(END, moved(0, 6, 2))]);
  expect(report).toMatchObject({ type: 'deform', unknowns: 32, settled: true, warnings: [] });
  expect(report.iterations).toBeGreaterThan(0);
  expect(Object.keys(report.seconds)).toEqual(
    expect.arrayContaining(['surface', 'fields', 'reduce', 'perIteration', 'settle']),
  );
  for (const v of END) {
    expect(model.positions[3 * v + 1]).toBeCloseTo(MODEL.positions[3 * v + 1]! + 6, 9);
    expect(model.positions[3 * v + 2]).toBeCloseTo(MODEL.positions[3 * v + 2]! + 2, 9);
  }
});

test('the result depends on the recipe alone, not on what was dragged before', async () => {
  const wanted = recipe([HELD, handle(END, moved(-4, 9, 0))]);
  const fresh = (await runner().run(wanted)).get('d')!.model.positions;
  const used = runner();
  for (const y of [3, 12, -7]) await used.ask(recipe([HELD, handle(END, moved(0, y, 0))]), 'd', 'drag', {});
  expect((await used.run(wanted)).get('d')!.model.positions).toEqual(fresh);
});

test('a drag from frame to frame comes to where the result is', async () => {
  const used = runner();
  for (const y of [2, 4, 6, 6, 6]) {
    const frame = await used.ask(recipe([HELD, handle(END, moved(0, y, 0))]), 'd', 'drag', {});
    expect(frame!.prepared.single).toBe(true);
  }
  const last = await used.ask(recipe([HELD, handle(END, moved(0, 6, 0))]), 'd', 'drag', {});
  const { positions, offsets } = await kernel.call('poseIsolines', {
    isolines: last!.prepared.id,
    targets: Float64Array.from([...moved(0, 0, 0), ...moved(0, 6, 0)]),
    settle: false,
  });
  const most = offsets.reduce((sum, x, i) => Math.max(sum, Math.abs(x - last!.offsets[i]!)), 0);
  expect(most).toBeLessThan(0.02 * 24);
  expect(gap(positions, MODEL.positions)).toBeGreaterThan(0.2);
});

test('reduced and full results are near each other, and each is what it says', async () => {
  const handles = [HELD, handle(END, moved(0, 6, 0))];
  const reduced = await run(handles, { settle: 'reduced' });
  const full = await run(handles);
  expect(reduced.report.settled).toBe(false);
  expect(gap(reduced.model.positions, full.model.positions)).toBeGreaterThan(0);
  expect(gap(reduced.model.positions, full.model.positions)).toBeLessThan(0.05);
});

test('handles that hold nothing, and none at all, leave the model and say so', async () => {
  const { model, report } = await run([handle([])]);
  expect(model.positions).toEqual(MODEL.positions);
  expect(report.warnings.map(({ code }) => code)).toEqual(['empty-handle', 'no-handle']);
  expect(await runner().ask(recipe([handle([])]), 'd', 'drag', {})).toBeNull();
});

test.each([
  ['handles that overlap', [HELD, handle([0, 1])], {}, /overlap|belongs to/],
  ['a vertex that is not there', [HELD, handle([99_999])], {}, /out of range/],
] as const)('%s are refused by name', async (_, handles, options, message) => {
  await expect(run(handles, options)).rejects.toThrow(message);
});

test('one handle takes the whole model along; forty are no trouble', async () => {
  const one = await run([handle(END, moved(0, 5, 0))]);
  for (let v = 0; v < MODEL.positions.length / 3; v += 7)
    expect(one.model.positions[3 * v + 1]).toBeCloseTo(MODEL.positions[3 * v + 1]! + 5, 6);
  const points = Array.from({ length: 40 }, (_, i) => {
    const vertex = 13 * i;
    const [x, y, z] = MODEL.positions.subarray(3 * vertex, 3 * vertex + 3);
    return { kind: 'point', vertices: [vertex], position: [x, y, z] };
  });
  const many = await run(points);
  expect(gap(many.model.positions, MODEL.positions)).toBeLessThan(1e-6);
});

test('what is set up is said before it is, once', async () => {
  const heard: { vertices: number; bytes: number; after: number }[] = [];
  const calls: string[] = [];
  const spy: KernelPort = {
    get epoch() {
      return kernel.epoch;
    },
    call: (method, args, options) => {
      calls.push(method);
      return kernel.call(method, args, options);
    },
  };
  const used = new Runner({ kernel: spy, models: { load: async () => MODEL } });
  const onPreparation = (preparation: { vertices: number; bytes: number }) =>
    void heard.push({ ...preparation, after: calls.length });
  const document = recipe([HELD, handle(END, moved(0, 6, 2))]);
  await used.run(document, { onPreparation });
  const vertices = MODEL.positions.length / 3;
  expect(heard.map((each) => each.vertices)).toEqual([vertices, vertices]);
  expect(heard[0]!.bytes).toBeGreaterThan(200 * vertices);
  // Asked for before anything is prepared, and said right before it is.
  expect(calls.indexOf('estimateIsolines')).toBeLessThan(calls.indexOf('prepareIsolineModel'));
  expect(heard.map(({ after }) => calls[after])).toEqual(['prepareIsolineModel', 'prepareIsolines']);
  heard.length = 0;
  for (const y of [3, 12])
    await used.ask(recipe([HELD, handle(END, moved(0, y, 0))]), 'd', 'drag', {}, { onPreparation });
  expect(heard).toEqual([]);
  expect(calls.filter((method) => method === 'estimateIsolines')).toHaveLength(1);
});

test('more controls take more, and a full pass too', async () => {
  const bytes = async (options: object) => {
    let most = 0;
    await runner().run(recipe([HELD, handle(END, moved(0, 6, 2))], options), {
      onPreparation: (preparation) => {
        most = preparation.bytes;
      },
    });
    return most;
  };
  const plain = await bytes({});
  expect(await bytes({ isolines: 40 })).toBeGreaterThan(plain);
  expect(await bytes({ settle: 'reduced' })).toBeLessThan(plain);
});

describe('too large for the method', () => {
  /** A kernel that says how much it would take, and must not be asked to begin. */
  class Estimating implements KernelPort {
    readonly epoch = 0;
    constructor(private readonly bytes: number) {}
    async call<M extends Method>(method: M): Promise<Result<M>> {
      if (method === 'openModel') return { id: 1, welded: new Int32Array() } as unknown as Result<M>;
      if (method === 'estimateIsolines')
        return { model: 1, session: this.bytes, settle: 0 } as unknown as Result<M>;
      throw new Error(`${method} was begun`);
    }
  }
  const large = (vertices: number, bytes: number) => {
    const positions = new Float64Array(3 * vertices);
    const model = {
      name: 'sheet',
      positions,
      faceOffsets: Uint32Array.of(0, 3),
      faceVertices: Uint32Array.of(0, 1, 2),
    };
    return new Runner({ kernel: new Estimating(bytes), models: { load: async () => model } });
  };
  const document = recipe([handle([0, 1]), handle([3, 4], moved(0, 1, 0))]);
  const refusal = (vertices: number, bytes: number) =>
    large(vertices, bytes)
      .run(document)
      .then(
        () => undefined,
        (error: unknown) => error as LissomError,
      );

  test('more than two million vertices are refused in a sentence, before anything is set up', async () => {
    const error = await refusal(2_000_001, 1);
    expect(error).toMatchObject({ code: 'isolines-too-large', fault: 'input' });
    expect(error?.message).toContain('2,000,001 vertices; the isoline method takes up to 2,000,000');
    expect((await refusal(2_000_000, 1))?.message).toContain('prepareIsolineModel was begun');
  });

  test('more than 4 GB are refused, with what it would take', async () => {
    const error = await refusal(1000, 20e9);
    expect(error).toMatchObject({ code: 'isolines-too-large', fault: 'input' });
    expect(error?.message).toMatch(/about 20 GB for 1,000 vertices and 2 handles/);
  });

  test('a drag that only borrows the method goes without it', async () => {
    const own = recipe([handle([0, 1]), handle([3, 4], moved(0, 1, 0))], {}, { method: 'implicit' });
    expect(await large(2_000_001, 1).ask(own, 'd', 'drag', {})).toBeNull();
    await expect(large(2_000_001, 1).ask(document, 'd', 'drag', {})).rejects.toMatchObject({
      code: 'isolines-too-large',
    });
  });
});
