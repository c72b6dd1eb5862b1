// Lines of a view and what a pull of one moves, on the real kernel, as the app asks for them.

import { beforeAll, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { loadKernel } from '../../web/kernel/node';
import { Runner } from '../../web/run/evaluate';
import { tube } from '../kernel/tubes';
import { recipeOfStep } from './curves-recipe';

/** A dome with a waist. */
const MODEL: Model = {
  name: 'm',
  ...tube(80, 80, (s, t) => {
    const r = (1 - s ** 6) * (1 + 0.25 * Math.sin(7 * s));
    return [r * Math.cos(t), 2 * s, r * Math.sin(t)];
  }),
};
const beltAt = (s: number) =>
  Array.from({ length: 7 }, (_, k): [number, number, number] => {
    const t = 1.2 + 0.12 * k;
    const r = (1 - s ** 6) * (1 + 0.25 * Math.sin(7 * s));
    return [r * Math.cos(t), 2 * s, r * Math.sin(t)];
  });
const BELT = beltAt(0.5);
const BY = [0.1, 0.05, 0.2] as const;
const recipeOf = (more: object = {}) =>
  recipeOfStep({ curves: [{ id: 'line 1', kind: 'contour', rest: BELT, reach: 0.4, ...more }] });

let runner: Runner;
beforeAll(async () => {
  runner = new Runner({ kernel: await loadKernel(), models: { load: async () => MODEL } });
});
const VIEW = { perspective: false, eye: [0.3, 0.4, 1] as [number, number, number] };

test('a view has lines on the surface as it is now', async () => {
  const ask = (positions: Float64Array) =>
    runner.ask(recipeOf(), 's', 'viewLines', { positions, sweeps: 5, view: VIEW });
  const rest = await ask(MODEL.positions);
  expect(rest.offsets.length).toBeGreaterThan(2);
  expect(rest.suggestive).toContain(1);
  const wide = MODEL.positions.map((x, i) => (i % 3 === 0 ? 1.5 * x : x));
  const other = await ask(wide);
  const widest = (points: Float64Array) =>
    points.reduce((most, x, i) => (i % 3 === 0 ? Math.max(most, x) : most), 0);
  expect(widest(other.points)).toBeGreaterThan(1.3 * widest(rest.points));
  for (const { points, corners, weights, positions } of [
    { ...rest, positions: MODEL.positions },
    { ...other, positions: wide },
  ])
    for (let i = 0; i < points.length; i += 3)
      for (let axis = 0; axis < 3; axis++) {
        const sum = [0, 1, 2].reduce(
          (s, k) => s + weights[i + k]! * positions[3 * corners[i + k]! + axis]!,
          0,
        );
        expect(Math.abs(sum - points[i + axis]!)).toBeLessThan(1e-6);
      }
});

test('a pull moves every vertex by its weight, nothing beyond the reach', async () => {
  const posed = BELT.map((point) => point.map((x, k) => x + BY[k]!));
  const weights = await runner.ask(recipeOf(), 's', 'pullWeights', { curve: 0 });
  expect(weights).toHaveLength(MODEL.positions.length / 3);
  const { model } = (await runner.run(recipeOf({ posed }))).get('s')!;
  let moved = 0;
  for (let v = 0; v < weights.length; v++) {
    const place = [0, 1, 2].map((k) => MODEL.positions[3 * v + k]!);
    const away = Math.min(...BELT.map((p) => Math.hypot(...p.map((x, k) => x - place[k]!))));
    if (away > 0.45) expect(weights[v]).toBe(0);
    if (weights[v]! > 0) moved++;
    for (let k = 0; k < 3; k++)
      expect(model.positions[3 * v + k]! - place[k]!).toBeCloseTo(weights[v]! * BY[k]!, 6);
  }
  expect(moved).toBeGreaterThan(100);
  expect(Math.max(...weights)).toBeCloseTo(1, 5);
});

test('beside other curves each line is asked about by its own number', async () => {
  const line = { id: 'line 1', kind: 'contour', rest: BELT, reach: 0.4 };
  const limb = { id: 'limb', kind: 'skeleton', rest: [0.1, 0.9, 1.7].map((y) => [0, y, 0]) };
  const recipe = recipeOfStep({ curves: [limb, line] });
  const alone = await runner.ask(recipeOf(), 's', 'pullWeights', { curve: 0 });
  const beside = await runner.ask(recipe, 's', 'pullWeights', { curve: 1 });
  const worst = alone.reduce((most, w, v) => Math.max(most, Math.abs(w - beside[v]!)), 0);
  expect(worst).toBeLessThan(1e-6);
});

test('a held line stays, and what lies across the pull from it goes along as before', async () => {
  const free = await runner.ask(recipeOf(), 's', 'pullWeights', { curve: 0 });
  const held = await runner.ask(recipeOf({ held: [beltAt(0.57)] }), 's', 'pullWeights', { curve: 0 });
  const sum = (weights: Float32Array, low: number, high: number) =>
    weights.reduce((s, w, v) => {
      const [x, y, z] = [0, 1, 2].map((k) => MODEL.positions[3 * v + k]!) as [number, number, number];
      const turn = Math.atan2(z, x);
      return s + (turn > 1.3 && turn < 1.8 && y > low && y < high ? w : 0);
    }, 0);
  expect(sum(held, 1.11, 1.17)).toBeLessThan(0.15 * sum(free, 1.11, 1.17));
  expect(sum(held, 0.7, 0.95)).toBeGreaterThan(0.9 * sum(free, 0.7, 0.95));
});
