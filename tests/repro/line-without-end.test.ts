// A line of the drawing with one place 8e19 away: it was walked along in steps of a five-hundredth of the model.

import { expect, test } from 'vitest';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import { sheet } from '../kernel/shapes';

test('a contour that runs on far beyond the model is posed, and ends', async () => {
  const shape = sheet(12, 12);
  const model = { name: 'm', ...shape };
  const size = Math.max(...shape.positions);
  const place = (x: number, y: number) => [x * size, y * size, 0];
  const recipe = parseRecipe(
    JSON.stringify({
      lissom: 1,
      models: { m: { file: 'm.obj' } },
      steps: [
        {
          id: 's',
          type: 'curves',
          model: 'm',
          curves: [
            {
              id: 'brow',
              kind: 'contour',
              rest: [place(0.2, 0.4), place(0.5, 0.4), place(0.7, 0.4), place(0.7, 8e19)],
              posed: [place(0.2, 0.45), place(0.5, 0.45), place(0.7, 0.45), place(0.7, 0.8)],
            },
          ],
        },
      ],
    }),
  );
  const runner = new Runner({ kernel: await loadKernel(), models: { load: async () => model } });
  const { positions } = (await runner.run(recipe)).get('s')!.model;
  expect(positions.every(Number.isFinite)).toBe(true);
});
