// What a drag of curves asks the kernel for, and when the vertices are computed instead.

import { signal } from '@preact/signals';
import { expect, test } from 'vitest';
import { curvesStrategy } from '../../web/app/curves/evaluation';
import type { Evaluating, Evaluation, Request } from '../../web/app/evaluated';
import type { CurveAttributes } from '../../web/kernel/contract/curve';
import { parseRecipe } from '../../web/recipe/parse';
import type { CurvesStep } from '../../web/recipe/recipe';

const recipe = parseRecipe({
  lissom: 1,
  models: { arm: { builtin: 'arm' } },
  steps: [
    {
      id: 'c',
      type: 'curves',
      model: 'arm',
      curves: [
        {
          id: 'a',
          kind: 'skeleton',
          rest: [
            [0, 0, 0],
            [0, 1, 0],
          ],
        },
      ],
    },
  ],
});
const step = recipe.steps[0] as CurvesStep;
const slabs: CurvesStep = { ...step, options: { ...step.options, encoding: 'slabs' } };

const shown = { key: 'arm', model: { positions: new Float64Array(6) } };
const attributes: CurveAttributes = {
  curves: new Uint16Array(8),
  rows: new Float32Array(8),
  weights: new Float32Array(8),
  centre: [0, 0, 0],
  frames: new Float64Array(),
  slopes: new Float64Array(9 * 256),
};
const before = {
  step,
  shown,
  positions: new Float64Array(6),
  report: { type: 'curves' },
} as unknown as Evaluation;

function world() {
  const asked: string[] = [];
  const prepared = { now: {} };
  const answers: Record<string, () => unknown> = {
    curveTable: () => ({ texels: new Float32Array(20 * 256), prepared: prepared.now }),
    curveAttributes: () => attributes,
  };
  const runner = {
    run: async () => {
      asked.push('run');
      const model = { positions: Float64Array.of(0, 1, 2, 3, 4, 5) };
      return new Map([['c', { inputs: [shown], model, report: before.report }]]);
    },
    ask: async (_recipe: unknown, _step: unknown, question: string) => {
      asked.push(question);
      return answers[question]!();
    },
    opened: async () => shown,
  };
  const evaluating = (shownBefore: Evaluation | null) =>
    ({
      runner,
      signal: new AbortController().signal,
      onProgress: () => {},
      before: shownBefore,
    }) as unknown as Evaluating;
  return { asked, prepared, evaluating };
}

const request = (of: CurvesStep, live: boolean): Request<CurvesStep> => ({
  recipe,
  step: of,
  live,
  wish: '',
});

const card = (movable: boolean, drawn = false) => ({
  movable: signal(movable),
  contours: { on: signal(drawn) },
});

test('a drag asks for a table a move, and once for what vertices go by', async () => {
  const { asked, prepared, evaluating } = world();
  const strategy = curvesStrategy(card(true));
  const first = await strategy.run(request(step, true), evaluating(before));
  expect(first).toMatchObject({ positions: before.positions, settled: false, report: before.report });
  expect(first.moved!.motion.vertexCount).toBe(2);
  const second = await strategy.run(request(step, true), evaluating(before));
  expect(second.moved!.motion).toBe(first.moved!.motion);
  expect(asked).toEqual(['curveTable', 'curveAttributes', 'curveTable']);
  // Other curves, or another worker.
  prepared.now = {};
  const third = await strategy.run(request(step, true), evaluating(before));
  expect(third.moved!.motion).not.toBe(first.moved!.motion);
});

test.each([
  ['the hand has let go', step, false, true, before],
  ['the model is a drawing', step, true, true, before, true],
  ['the card cannot hold the model', step, true, false, before],
  ['planes pose it', slabs, true, true, before],
  ['nothing is on screen yet', step, true, true, null],
  ['another step is', step, true, true, { ...before, step: { ...step, id: 'other' } }],
  ['it has not been run yet', step, true, true, { ...before, report: null }],
] as const)('vertices are computed where %s', async (_, of, live, movable, shownBefore, drawn?: boolean) => {
  const { asked, evaluating } = world();
  const outcome = await curvesStrategy(card(movable, drawn)).run(request(of, live), evaluating(shownBefore));
  expect(asked).toEqual(['run']);
  expect(outcome.moved).toBeUndefined();
  expect([...outcome.positions]).toEqual([0, 1, 2, 3, 4, 5]);
});
