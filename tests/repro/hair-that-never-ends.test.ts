// A head with one coordinate of 1e30: the grid of the hair lay so far away that counting its nodes ran over.

import { expect, test } from 'vitest';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import { HAIR } from '../fuzz/recipes';
import { egg } from '../kernel/hair-shapes';

test('a head with a vertex beyond all others is refused with what to do', async () => {
  const { positions, ...faces } = egg();
  const head = { name: 'h', ...faces, positions: positions.slice() };
  head.positions[1592] = 1e30;
  const runner = new Runner({ kernel: await loadKernel(), models: { load: async () => head } });
  await expect(runner.run(parseRecipe(HAIR))).rejects.toMatchObject({
    code: 'scalp-too-small',
    message: expect.stringMatching(/numbers do not tell its places apart\. Move those vertices/),
  });
});
