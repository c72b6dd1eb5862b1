// Deform steps by the isoline method, through the real kernel.

import { beforeAll, expect, test } from 'vitest';
import type { KernelPort } from '../../web/kernel/contract';
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
