// Curves through the bridge, on the real kernel: what holds whatever the method is.

import { beforeAll, expect, test } from 'vitest';
import type { Args, KernelPort } from '../../web/kernel/contract';
import type { CurveOptions, CurvePosture } from '../../web/kernel/contract/curve';
import { loadKernel } from '../../web/kernel/node';
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
const spec = (rest: Float64Array) => ({
  rest,
  role: 'limb' as const,
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

test('the shader draws what the core computes', async () => {
  const half = (from: number) => Float64Array.from([0, 4, 8].flatMap((x) => place(from + x)));
  const { made } = await prepared(shape, [spec(half(0)), spec(half(8))], [{ child: 1, parent: 0, at: 1 }]);
  const bent = Float64Array.from([...place(0), ...place(4, 0.2), ...place(8, 1)]);
  const postures = [
    { ...REST, points: bent },
    { ...REST, twist: Float64Array.of(0, 30, 60), scale: Float64Array.of(1, 1, 1.2, 1, 1.5, 1.2) },
  ];
  const { positions } = await kernel.call('poseCurves', { curves: made.id, postures });
  const attributes = await kernel.call('curveAttributes', { curves: made.id });
  const { texels } = await kernel.call('curveTable', { curves: made.id, postures });
  const drawn = shape.positions.map((_, k) => shaded(attributes, texels, Math.floor(k / 3))[k % 3]!);
  expect(gap(drawn, positions)).toBeLessThan(2e-4 * LENGTH);
});

/** One vertex as the shader moves it: the table's words, in double precision. */
function shaded(
  { rows, weights, centre }: { rows: Float32Array; weights: Float32Array; centre: readonly number[] },
  texels: Float32Array,
  v: number,
): number[] {
  const x = [0, 1, 2].map((k) => shape.positions[3 * v + k]! - centre[k]!);
  const [real, dual, point] = [
    [0, 0, 0, 0],
    [0, 0, 0, 0],
    [0, 0, 0],
  ];
  for (let k = 0; k < 4; k++) {
    const weight = weights[4 * v + k]!;
    if (weight === 0) continue;
    const row = Math.floor(rows[4 * v + k]!);
    const share = rows[4 * v + k]! - row;
    const next = row % 256 === 255 ? row : row + 1;
    const texel = (t: number) =>
      [0, 1, 2, 3].map(
        (c) => (1 - share) * texels[4 * (5 * row + t) + c]! + share * texels[4 * (5 * next + t) + c]!,
      );
    const [r, d] = [texel(0), texel(1)];
    const sided = real.reduce((sum, a, c) => sum + a * r[c]!, 0) < 0 ? -weight : weight;
    for (let c = 0; c < 4; c++) {
      real[c]! += sided * r[c]!;
      dual[c]! += sided * d[c]!;
    }
    for (let a = 0; a < 3; a++) {
      const line = texel(2 + a);
      point[a]! += weight * (line[0]! * x[0]! + line[1]! * x[1]! + line[2]! * x[2]! + line[3]!);
    }
  }
  const norm = Math.hypot(...real);
  const [r, d] = [real.map((c) => c / norm), dual.map((c) => c / norm)];
  const cross = (a: number[], b: number[]) => [
    a[1]! * b[2]! - a[2]! * b[1]!,
    a[2]! * b[0]! - a[0]! * b[2]!,
    a[0]! * b[1]! - a[1]! * b[0]!,
  ];
  const inner = cross(r, point).map((c, k) => c + r[3]! * point[k]!);
  const turned = cross(r, inner);
  const carried = cross(r, d);
  return [0, 1, 2].map(
    (k) => point[k]! + 2 * turned[k]! + 2 * (r[3]! * d[k]! - d[3]! * r[k]! + carried[k]!) + centre[k]!,
  );
}

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
