// Blend and dress steps on the real kernel: by the skins of a match.

import { beforeAll, describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import type { Recipe } from '../../web/recipe/recipe';
import type { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';
import { FRUIT, fruitRunner, match, recipeOf } from './fruit';

const blend = (more: object = {}) => ({
  id: 'b',
  type: 'blend',
  match: 'm',
  weights: { pear: 0.5, plum: 0.5 },
  ...more,
});
const dress = (more: object = {}) => ({
  id: 'd',
  type: 'dress',
  garment: 'belt',
  match: 'm',
  from: 'pear',
  to: 'plum',
  ...more,
});
let runner: Runner;
beforeAll(async () => {
  runner = await fruitRunner();
});

const run = async (...steps: object[]) => {
  const results = await runner.run(recipeOf(match(), ...steps));
  return {
    blend: results.get('b') as StepResult<'blend'>,
    dress: results.get('d') as StepResult<'dress'>,
    skins: results.get('m')!.models!,
  };
};
const codes = ({ report }: StepResult) => report.warnings.map(({ code }) => code);
const extent = ({ positions }: Model, axis: number) => {
  const along = positions.filter((_, at) => at % 3 === axis);
  return along.reduce((a, b) => Math.max(a, b)) - along.reduce((a, b) => Math.min(a, b));
};

describe('blend', () => {
  test('is the sum of the skins by weights; one that is left out counts for nothing', async () => {
    const { blend: half, skins } = await run(blend());
    for (let at = 0; at < half.model.positions.length; at += 11)
      expect(half.model.positions[at]).toBeCloseTo(
        (skins.pear!.positions[at]! + skins.plum!.positions[at]!) / 2,
        12,
      );
    expect(half.model.faceVertices).toBe(skins.pear!.faceVertices);
    expect(half.report.weights).toEqual({ pear: 0.5, plum: 0.5 });
    const { blend: one } = await run(blend({ weights: { plum: 1 } }));
    expect(one.model.positions).toEqual(skins.plum!.positions);
    expect(codes(one)).toEqual([]);
  });

  test('weights that make no whole are told', async () => {
    expect(codes((await run(blend({ weights: { pear: 0.7, plum: 0.7 } }))).blend)).toEqual([
      'weights-not-whole',
    ]);
  });

  test('measures are reached, and reported with what is left', async () => {
    const measures = [
      { kind: 'height', value: 2.2 },
      { kind: 'height', up: [1, 0, 0] },
    ];
    const { blend: made } = await run(blend({ weights: {}, measures }));
    expect(extent(made.model, 1)).toBeCloseTo(2.2, 3);
    const [tall, wide] = made.report.measures;
    expect(tall).toMatchObject({ kind: 'height', value: 2.2 });
    expect(tall!.residual).toBeCloseTo(0, 3);
    expect(wide).toEqual({ kind: 'height', reached: extent(made.model, 0) });
    expect(made.report.weights.pear! + made.report.weights.plum!).toBeCloseTo(1, 9);
    const asked = recipeOf(match(), blend({ measures }));
    const spans = await runner.ask(asked, 'b', 'measures', parseMeasures(asked));
    expect(spans.pear![0]).toBeGreaterThan(spans.plum![0]!);
  });

  test('a part is taken from one model, the rest stays', async () => {
    const { skins } = await run(blend());
    const vertices = [...skins.pear!.positions.keys()]
      .filter((at) => at % 3 === 1 && skins.pear!.positions[at]! > 0.8)
      .map((at) => (at - 1) / 3);
    for (const how of ['paste', 'low-pass']) {
      const { blend: made } = await run(
        blend({ weights: { pear: 1 }, parts: [{ from: 'plum', vertices, how }] }),
      );
      const moved = vertices.some(
        (v) => Math.abs(made.model.positions[3 * v]! - skins.pear!.positions[3 * v]!) > 0.01,
      );
      expect(moved).toBe(true);
      expect(extent(made.model, 1)).toBeLessThanOrEqual(extent(skins.pear!, 1) + 0.2);
    }
  });

  test.each<[string, object]>([
    ['recipe-invalid', { weights: { apple: 1 } }],
    ['recipe-invalid', { parts: [{ from: 'apple', vertices: [1] }] }],
    ['recipe-invalid', { match: 'pear' }],
    ['recipe-invalid', { measures: [{ kind: 'girth' }] }],
    ['no-weights', { weights: {} }],
    ['no-weights', { weights: { pear: 0 } }],
    ['empty-part', { parts: [{ from: 'plum', vertices: [] }] }],
    ['whole-part', { parts: [{ from: 'plum', vertices: 'all' }] }],
    ['index-out-of-range', { parts: [{ from: 'plum', vertices: [123_456] }] }],
    ['index-out-of-range', { measures: [{ kind: 'length', path: [0, 123_456] }] }],
    ['bad-measure', { measures: [{ kind: 'girth', loop: [0, 1], value: 1 }] }],
  ])('%s %#', async (code, more) => {
    await expect(async () => run(blend(more))).rejects.toMatchObject({ code });
  });
});

describe('dress', () => {
  test('the garment keeps its faces, fits the other body and is not inside it', async () => {
    const { dress: worn } = await run(dress());
    expect(worn.model.faceVertices).toBe(FRUIT.belt.faceVertices);
    expect(worn.report).toMatchObject({
      inside: 0,
      insideCentres: 0,
      vertices: FRUIT.belt.positions.length / 3,
    });
    expect(extent(worn.model, 0)).toBeGreaterThan(1.3 * 2.1);
    // What is said is what is said of the belt.
    expect(codes(worn)).toEqual(['open-boundary']);
  });

  test('ease is asked of what is prepared already, and the way back leads back', async () => {
    const { dress: wide } = await run(dress({ offset: 0.2 }));
    const { dress: plain } = await run(dress());
    expect(extent(wide.model, 0) - extent(plain.model, 0)).toBeCloseTo(0.4, 1);
    const { dress: back } = await run(dress({ from: 'pear', to: 'pear' }));
    for (let at = 0; at < back.model.positions.length; at += 13)
      expect(back.model.positions[at]).toBeCloseTo(FRUIT.belt.positions[at]!, 2);
  });

  test.each<[string, object]>([
    ['recipe-invalid', { to: 'apple' }],
    ['recipe-invalid', { from: 'belt' }],
    ['recipe-invalid', { match: 'd' }],
    ['recipe-invalid', { garment: 'm' }],
  ])('%s %#', async (code, more) => {
    await expect(async () => run(dress(more))).rejects.toMatchObject({ code });
  });
});

function parseMeasures({ steps }: Recipe) {
  const step = steps[1]!;
  return step.type === 'blend' ? step.measures : [];
}
