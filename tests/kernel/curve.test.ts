// Curves through the bridge, on the real kernel: what holds whatever the method is.

import { beforeAll, expect, test } from 'vitest';
import type { Args, KernelPort } from '../../web/kernel/contract';
import type { CurveOptions, CurvePosture } from '../../web/kernel/contract/curve';
import { loadKernel } from '../../web/kernel/node';
import { posed } from '../view/curves/curve-reference';
import { bar, gap, type Shape } from './shapes';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const LENGTH = 16;
const shape = bar(LENGTH, 2);
/** The axis of the bar, which lies along x. */
const middle = [1, 2].map((axis) => {
  const along = shape.positions.filter((_, k) => k % 3 === axis);
  return (Math.min(...along) + Math.max(...along)) / 2;
});
const place = (x: number, aside = 0) => [x, middle[0]! + aside, middle[1]!];
const axis = (bend = 0) =>
  Float64Array.from([0, 4, 8, 12, 16].flatMap((x) => place(x, bend * (x / LENGTH) ** 2)));

const OPTIONS: CurveOptions = { blending: 'ownership', encoding: 'kernel', guard: 'symmetric' };
const REST: CurvePosture = {
  points: new Float64Array(),
  base: new Float64Array(),
  twist: new Float64Array(),
  scale: new Float64Array(),
};
const spec = (rest: Float64Array, role: 'limb' | 'contour' = 'limb') => ({
  rest,
  role,
  rigid: new Uint32Array(),
  region: null,
  anchor: 'start' as const,
  reach: 0,
  held: [],
});

async function prepared(model: Shape, curves = [spec(axis())], links: Args<'prepareCurves'>['links'] = []) {
  const opened = await kernel.call('openModel', { ...model });
  const made = await kernel.call('prepareCurves', { model: opened.id, curves, links, options: OPTIONS });
  return { model: opened.id, made };
}

test('at rest the model is itself, and a bend moves its far end', async () => {
  const { made } = await prepared(shape);
  expect(made.warnings).toEqual([]);
  expect(made.curves[0]!.anchor).toBe('start');
  expect(made.curves[0]!.radii).toHaveLength(5);
  expect(made.curves[0]!.region.length).toBeGreaterThan(0);
  const rest = await kernel.call('poseCurves', { curves: made.id, postures: [REST] });
  expect(gap(rest.positions, shape.positions)).toBeLessThan(1e-11);
  const bent = await kernel.call('poseCurves', { curves: made.id, postures: [{ ...REST, points: axis(3) }] });
  expect(gap(bent.positions, shape.positions)).toBeGreaterThan(0.1);
  expect(bent.positions.every(Number.isFinite)).toBe(true);
  expect(bent.bend).toBeGreaterThan(0);
  expect(bent.tilt).toBe(0);
});

test('the graphics card’s formula makes what the core computes, places and normals', async () => {
  const half = (from: number) => Float64Array.from([0, 4, 8].flatMap((x) => place(from + x)));
  const limbs = [spec(half(0)), spec(half(8))];
  const links = [{ child: 1, parent: 0, at: 1 }];
  const postures = [
    { ...REST, points: Float64Array.from([...place(0), ...place(4, 0.2), ...place(8, 1)]) },
    { ...REST, twist: Float64Array.of(0, 30, 60), scale: Float64Array.of(1, 1, 1.2, 1, 1.5, 1.2) },
  ];
  const line = spec(Float64Array.from([...place(6, 1), ...place(10, 1)]), 'contour');
  const pulled = { ...REST, points: Float64Array.from([...place(6, 1.2), ...place(10, 1.5)]) };
  const bent = { ...REST, points: axis(3), base: Float64Array.of(0.1, 0, 0, Math.sqrt(0.99)) };
  const cases = [
    { made: await prepared(shape, limbs, links), postures },
    { made: await prepared(shape, [...limbs, line], links), postures: [...postures, pulled] },
    { made: await prepared(shape), postures: [bent] },
  ];
  const resting = Float64Array.from(shape.positions, (_, k) => Math.sin(k - (k % 3) + 7 * (k % 3)));
  for (let v = 0; v < resting.length; v += 3) {
    const size = Math.hypot(resting[v]!, resting[v + 1]!, resting[v + 2]!);
    for (const k of [0, 1, 2]) resting[v + k]! /= size;
  }
  for (const { made, postures } of cases) {
    const curves = made.made.id;
    const { positions } = await kernel.call('poseCurves', { curves, postures });
    const { normals } = await kernel.call('curveNormals', { curves, postures, normals: resting });
    const attributes = await kernel.call('curveAttributes', { curves });
    const { texels } = await kernel.call('curveTable', { curves, postures });
    const drawn = posed(attributes, texels, shape.positions, resting);
    expect(gap(drawn.positions, positions)).toBeLessThan(1e-6);
    // The table is in single precision, and normals have the difference of two of its 256 rows in them.
    const turned = normals.reduce((worst, x, k) => Math.max(worst, Math.abs(x - drawn.normals[k]!)), 0);
    console.log(
      `formula and core: ${gap(drawn.positions, positions).toExponential(1)}, normals ${turned.toExponential(1)}`,
    );
    expect(turned).toBeLessThan(2e-5);
  }
});

test('a drag that would fold the model is stopped on its way', async () => {
  const { made } = await prepared(shape);
  const folded = Float64Array.from([
    ...place(0),
    ...place(4),
    ...place(8),
    ...place(4, 0.2),
    ...place(0, 0.4),
  ]);
  const from = [{ ...REST, points: axis() }];
  const stopped = await kernel.call('curveDragLimit', {
    curves: made.id,
    from,
    to: [{ ...REST, points: folded }],
  });
  expect(stopped.share).toBeGreaterThan(0);
  expect(stopped.share).toBeLessThan(1);
  const free = await kernel.call('curveDragLimit', {
    curves: made.id,
    from,
    to: [{ ...REST, points: axis(1) }],
  });
  expect(free.share).toBe(1);
});

test('a chain reaches for its target', async () => {
  const { points, reached } = await kernel.call('reachCurve', {
    points: axis(),
    end: 4,
    target: [8, 8, 0],
    held: Uint32Array.of(0),
  });
  expect(reached).toBe(true);
  expect(Math.hypot(points[12]! - 8, points[13]! - 8, points[14]!)).toBeLessThan(1e-5);
});

test('crossings are counted, and the faces named', async () => {
  const { model, made } = await prepared(shape);
  const count = (positions: Float64Array) => kernel.call('selfIntersections', { model, positions });
  expect(await count(shape.positions)).toEqual({ pairs: 0, faces: new Uint32Array() });
  const flat = shape.positions.map((x, k) => (k % 3 === 0 ? Math.abs(x - LENGTH / 2) : x)); // folded onto itself
  const folded = await count(flat);
  expect(folded.pairs).toBeGreaterThan(0);
  expect(folded.faces.length).toBeGreaterThan(0);
  await expect(count(new Float64Array(3))).rejects.toMatchObject({ code: 'wrong-size' });
  await kernel.call('release', { id: made.id });
});

test('what the kernel refuses comes by its code', async () => {
  const { made } = await prepared(shape);
  await expect(
    kernel.call('poseCurves', { curves: made.id, postures: [{ ...REST, twist: Float64Array.of(1) }] }),
  ).rejects.toMatchObject({ code: 'curve-twist' });
  await expect(prepared(shape, [])).rejects.toMatchObject({ code: 'no-curve' });
});
