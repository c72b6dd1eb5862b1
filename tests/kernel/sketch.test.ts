// Curves drawn on a model, through the bridge, on the real kernel.

import { beforeAll, expect, test } from 'vitest';
import type { KernelId, KernelPort } from '../../web/kernel/contract';
import type { SketchOptions } from '../../web/kernel/contract/sketch';
import { loadKernel } from '../../web/kernel/node';
import { bar, type Shape, sheet, verticesWhere } from './shapes';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const shape = bar(24, 4);

async function prepare(of: Shape = shape): Promise<KernelId> {
  const { id: model } = await kernel.call('openModel', of);
  const { id, seconds } = await kernel.call('prepareSketch', { model });
  await kernel.call('release', { id: model }); // a sketch keeps what it needs
  expect(seconds.surface).toBeGreaterThanOrEqual(0);
  return id;
}

/** A straight stroke seen from +z, twenty pixels a unit. */
function stroke(from: readonly [number, number], to: readonly [number, number], steps = 80, z = 100) {
  const at = Array.from({ length: steps + 1 }, (_, k) => {
    const share = steps === 0 ? 0 : k / steps;
    return [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])] as const;
  });
  return {
    pixels: Float64Array.from(at.flatMap(([x, y]) => [20 * x, 20 * y])),
    origins: Float64Array.from(at.flatMap(([x, y]) => [x, y, z])),
    directions: Float64Array.from(at.flatMap(() => [0, 0, -1])),
  };
}

const sketched = async (drawn: ReturnType<typeof stroke>, options: SketchOptions = {}, of?: Shape) =>
  kernel.call('sketchCurve', { sketch: await prepare(of), ...drawn, options });

test('a stroke along a bar becomes its axis, and what lies between its ends follows', async () => {
  const sketch = await prepare();
  const curve = await kernel.call('sketchCurve', { sketch, ...stroke([6.2, 1.5], [18.2, 2.5]) });
  expect(curve.kind).toBe('skeleton');
  expect(curve.warnings).toEqual([]);
  for (let i = 0; i < curve.points.length; i += 3) {
    expect(curve.points[i + 1]).toBeCloseTo(2, 1);
    expect(curve.points[i + 2]).toBeCloseTo(2, 1);
  }
  const { points, radius, hits } = curve;
  const found = await kernel.call('curveRegion', { sketch, points, options: { radius, hits } });
  expect([...found.vertices]).toEqual([...verticesWhere(shape, (x) => x > 6.3 && x < 18.1)]);
  expect([...found.startSide]).toEqual([...verticesWhere(shape, (x) => x < 6.3)]);
  expect([...found.endSide]).toEqual([...verticesWhere(shape, (x) => x > 18.1)]);
  expect(found.between).toHaveLength(0);
  // From the curve alone, as a recipe has it.
  const alone = await kernel.call('curveRegion', { sketch, points });
  expect(alone.vertices).toEqual(found.vertices);
});

test('surface curves, sheets and overshooting strokes are told', async () => {
  const on = await sketched(stroke([6, 2], [18, 2]), { kind: 'surface' });
  expect(on.kind).toBe('surface');
  expect(on.points.filter((_, at) => at % 3 === 2).every((z) => Math.abs(z - 4) < 1e-9)).toBe(true);
  const flat = await sketched(stroke([2, 5], [10, 5]), { kind: 'skeleton' }, sheet(12, 12));
  expect(flat.kind).toBe('surface');
  expect(flat.warnings.map(({ code }) => code)).toEqual(['open-sheet']);
  const long = await sketched(stroke([-5, 2], [30, 2]));
  expect(long.warnings.map(({ code }) => code)).toEqual(['stroke-overshoots']);
});

test.each([
  ['off the model', stroke([0, 9], [20, 9]), 'stroke-off-model'],
  ['of one point', stroke([5, 2], [5, 2], 0), 'stroke-too-short'],
  ['of no point', stroke([5, 2], [5, 2], -1), 'stroke-too-short'],
  ['drawn from inside', stroke([5, 2], [15, 2], 80, 2.1), 'eye-inside-model'],
  ['with rays missing', { ...stroke([5, 2], [15, 2]), origins: Float64Array.of(0, 0, 9) }, 'bad-stroke'],
])('a stroke %s is refused in words', async (_, drawn, code) => {
  await expect(sketched(drawn)).rejects.toMatchObject({ code, fault: 'input' });
});

test('a curve near nothing has no region; radii and hits that do not fit are refused', async () => {
  const sketch = await prepare();
  const far = Float64Array.of(0, 99, 0, 9, 99, 0);
  const none = await kernel.call('curveRegion', { sketch, points: far });
  expect(none.vertices).toHaveLength(0);
  const points = Float64Array.of(6, 2, 2, 18, 2, 2);
  const asked = (options: object) => kernel.call('curveRegion', { sketch, points, options });
  await expect(asked({ radius: Float64Array.of(1) })).rejects.toMatchObject({ code: 'curve-radius' });
  await expect(asked({ hits: Uint32Array.of(1e9) })).rejects.toMatchObject({ code: 'curve-hits' });
  await expect(asked({ kappa: -1 })).rejects.toMatchObject({ code: 'curve-reach' });
  await expect(asked({ method: 'magic' })).rejects.toMatchObject({ code: 'bad-option' });
  expect((await asked({ method: 'planes' })).vertices.length).toBeGreaterThan(0);
});

test('a bar is proposed one curve, a cube none', async () => {
  const { curves, links } = await kernel.call('proposeCurves', { sketch: await prepare() });
  expect(curves).toHaveLength(1);
  expect(links).toHaveLength(0);
  await expect(kernel.call('proposeCurves', { sketch: await prepare(bar(4, 4)) })).rejects.toMatchObject({
    code: 'no-limbs',
  });
});

test('a pulled line has weights that other lines keep away', async () => {
  const sketch = await prepare(sheet(40, 40));
  const line = Float64Array.of(10, 20, 0, 30, 20, 0);
  const free = await kernel.call('lineWeights', { sketch, line, others: [], radius: 8 });
  const other = Float64Array.of(10, 22, 0, 30, 22, 0);
  const held = await kernel.call('lineWeights', { sketch, line, others: [other], radius: 8 });
  const sum = (numbers: Float64Array) => numbers.reduce((a, b) => a + b, 0);
  expect(sum(held.weights)).toBeLessThan(0.9 * sum(free.weights));
  expect(free.along.every((share) => share >= 0 && share <= 1)).toBe(true);
  const short = Float64Array.of(1, 1, 0);
  await expect(kernel.call('lineWeights', { sketch, line: short, others: [] })).rejects.toMatchObject({
    code: 'line-too-short',
  });
});
