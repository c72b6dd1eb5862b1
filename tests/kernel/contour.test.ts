// Contours of a view, through the bridge, on the real kernel.

import { beforeAll, expect, test } from 'vitest';
import type { KernelPort } from '../../web/kernel/contract';
import type { ContourOptions, ContourView } from '../../web/kernel/contract/contour';
import { loadKernel } from '../../web/kernel/node';
import type { Shape } from './shapes';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

/** Around z, radii 1 and 0.4. */
function torus(around: number, across: number): Shape {
  const positions = Array.from({ length: around * across }, (_, v) => {
    const a = (2 * Math.PI * Math.floor(v / across)) / around;
    const b = (2 * Math.PI * (v % across)) / across;
    const r = 1 + 0.4 * Math.cos(b);
    return [r * Math.cos(a), r * Math.sin(a), 0.4 * Math.sin(b)];
  });
  const faces = Array.from({ length: around * across }, (_, v) => {
    const [i, j] = [Math.floor(v / across), v % across];
    const at = (di: number, dj: number) => ((i + di) % around) * across + ((j + dj) % across);
    return [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
  });
  return {
    positions: Float64Array.from(positions.flat()),
    faceOffsets: Uint32Array.from({ length: faces.length + 1 }, (_, f) => 4 * f),
    faceVertices: Uint32Array.from(faces.flat()),
  };
}

async function prepare(): Promise<ReturnType<typeof lines>> {
  const { id: model } = await kernel.call('openModel', torus(96, 40));
  const { id: contours } = await kernel.call('prepareContours', { model, sweeps: 3 });
  await kernel.call('release', { id: model });
  return lines(contours);
}

const lines =
  (contours: Awaited<ReturnType<typeof kernel.call<'prepareContours'>>>['id']) =>
  (view: ContourView, options?: ContourOptions) =>
    kernel.call('contourLines', options ? { contours, view, options } : { contours, view });

const above: ContourView = { perspective: false, eye: [0, 0, 1] };
const aslant: ContourView = { perspective: false, eye: [0.3, 0.5, 0.8] };

test('from above a torus has its two circles, which neither light nor size makes more of', async () => {
  const ask = await prepare();
  const { points, offsets, corners, weights, suggestive, closed } = await ask(above, { suggestive: false });
  expect([...closed]).toEqual([1, 1]);
  expect([...suggestive]).toEqual([0, 0]);
  expect(offsets.at(-1)).toBe(points.length / 3);
  expect([corners.length, weights.length]).toEqual([points.length, points.length]);
  const radii = [0, 1].map((line) => {
    const at = 3 * offsets[line]!;
    return Math.hypot(points[at]!, points[at + 1]!);
  });
  expect(radii[0]).toBeCloseTo(1.4, 2);
  expect(radii[1]).toBeCloseTo(0.6, 2);
});

test('aslant it has suggestive contours as well, and every view of a session is its own', async () => {
  const ask = await prepare();
  const first = await ask(aslant);
  expect([...first.suggestive].some((flag) => flag === 1)).toBe(true);
  await ask({ perspective: true, eye: [4, 0, 1] });
  const again = await ask(aslant);
  expect(again.points).toEqual(first.points);
});

test('of two views asked for at once the newer one is answered', async () => {
  const ask = await prepare();
  const answers = await Promise.allSettled([ask(above), ask(aslant)]);
  expect(answers[1].status).toBe('fulfilled');
  if (answers[0].status === 'rejected') expect(answers[0].reason).toMatchObject({ code: 'view-replaced' });
});

test('a view without direction and smoothing without end are refused', async () => {
  const ask = await prepare();
  await expect(ask({ perspective: false, eye: [0, 0, 0] })).rejects.toMatchObject({ code: 'bad-view' });
  await expect(ask({ perspective: true, eye: [Number.NaN, 0, 0] })).rejects.toMatchObject({
    code: 'bad-view',
  });
  const { id: model } = await kernel.call('openModel', torus(8, 6));
  await expect(kernel.call('prepareContours', { model, sweeps: 1e6 })).rejects.toMatchObject({
    code: 'bad-option',
  });
});
