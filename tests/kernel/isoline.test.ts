import { beforeAll, expect, test } from 'vitest';
import type { KernelPort } from '../../web/kernel/contract';
import type { IsolineOptions } from '../../web/kernel/contract/isoline';
import type { HandleSpec } from '../../web/kernel/contract/model';
import { loadKernel } from '../../web/kernel/node';
import { blended } from '../view/deform/isoline-reference';
import { affine, allVertices, bar, gap, transformed, verticesWhere } from './shapes';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const shape = bar(24, 5);
const still = affine(
  [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  [0, 0, 0],
);
const turned = affine(
  [
    [0, -1, 0],
    [1, 0, 0],
    [0, 0, 1],
  ],
  [-4, 5, 2],
);

async function prepare(options: IsolineOptions = {}, count = 2) {
  const { id: model } = await kernel.call('openModel', shape);
  const surface = await kernel.call('prepareIsolineModel', { model });
  const handles = [
    { kind: 'region', vertices: verticesWhere(shape, (x) => x < 1.5) },
    { kind: 'region', vertices: verticesWhere(shape, (x) => x > 22.5) },
    { kind: 'region', vertices: verticesWhere(shape, (x) => x > 10.5 && x < 13.5) },
  ].slice(0, count) as [HandleSpec, HandleSpec];
  const prepared = await kernel.call('prepareIsolines', {
    isolineModel: surface.id,
    roi: allVertices(shape),
    handles,
    options,
  });
  return { model, surface, handles, isolines: prepared.id, prepared };
}

test('a common rigid motion of the handles is that of the model, even after what it was made of is released', async () => {
  const { model, surface, isolines, prepared } = await prepare();
  expect(surface).toMatchObject({ proxy: false, smoothed: false });
  expect(prepared).toMatchObject({ single: true, sets: 1, basis: 'quadratic', controls: 10, unknowns: 32 });
  await kernel.call('release', { id: model });
  await kernel.call('release', { id: surface.id });
  const targets = Float64Array.from([...turned, ...turned]);
  const { positions, iterations } = await kernel.call('poseIsolines', { isolines, targets, settle: false });
  expect(iterations).toBeGreaterThan(0);
  expect(gap(positions, transformed(shape.positions, turned))).toBeLessThan(1e-7);
  const settled = await kernel.call('poseIsolines', { isolines, targets, settle: true });
  expect(gap(settled.positions, transformed(shape.positions, turned))).toBeLessThan(1e-4);
});

test.each([
  ['quadratic', 10, 2],
  ['hats', 20, 2],
  ['quadratic', 10, 3],
] as const)(
  'a frame says how to blend, %s with %i controls and %i handles: fields and controls give the positions',
  async (basis, controls, count) => {
    const { isolines, prepared } = await prepare({ basis, controls }, count);
    const targets = Float64Array.from([...still, ...turned, ...still].slice(0, 16 * count));
    const { offsets } = await kernel.call('dragIsolines', { isolines, targets, solves: 8 });
    const surface = await kernel.call('isolineFields', { isolines });
    const sets = count === 2 ? 1 : count + prepared.freeHandles;
    expect(offsets).toHaveLength(12 * sets * controls);
    expect(surface.gradients).toHaveLength(sets * shape.positions.length);
    expect(surface.still.some((flag) => flag === 1)).toBe(false);
    const posed = await kernel.call('poseIsolines', { isolines, targets, settle: false });
    const expected = blended({ ...prepared, ...surface }, posed.offsets, shape.positions);
    expect(gap(expected, posed.positions)).toBeLessThan(1e-5);
  },
);

test('fields, rigidity and isolines can be looked at', async () => {
  const { isolines, handles } = await prepare();
  const { values } = await kernel.call('isolineField', { isolines, handle: 1, what: 'field' });
  for (const v of handles[1].vertices) expect(values[v]).toBe(1);
  for (const v of handles[0].vertices) expect(values[v]).toBe(0);
  const rigidity = await kernel.call('isolineField', { isolines, handle: -1, what: 'rigidity' });
  expect(rigidity.values.some((value) => value > 0)).toBe(true);
  const { points, offsets } = await kernel.call('isolineCurves', { isolines, handle: 0, count: 10 });
  expect(offsets).toHaveLength(8 + 1); // one loop around the bar each
  expect(offsets.at(-1)).toBe(points.length / 3);
  await expect(kernel.call('isolineField', { isolines, handle: 7, what: 'field' })).rejects.toMatchObject({
    code: 'handle-count',
  });
});

test('memory is stated before anything starts, and options that make no sense are refused', async () => {
  const { id: model } = await kernel.call('openModel', shape);
  const said = await kernel.call('estimateIsolines', { model, handles: 2, options: {} });
  expect(said.session).toBeGreaterThan(0);
  const more = await kernel.call('estimateIsolines', { model, handles: 2, options: { controls: 100 } });
  expect(more.session).toBeGreaterThan(said.session);
  expect(said.settle).toBeGreaterThan(0);
  await expect(prepare({ controls: 1 })).rejects.toMatchObject({ code: 'bad-option' });
});
