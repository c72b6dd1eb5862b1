// One coordinate of 1e30 made a boundary of which all but two edges are next to nothing: every vertex of the other one
// came to lie on one edge, and that triangle was cut up by a search that is cubic in them, for hours.

import { beforeAll, describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import { bowl, dome, tube } from '../kernel/tubes';
import { meter } from './bounded';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const upTo = (count: number) => Array.from({ length: count }, (_, i) => i);

/** A model whose first coordinate lies elsewhere; its loop of vertices comes first. */
function tubeWith(x: number | undefined, around: number, of: typeof dome, upward = true): Model {
  const { positions, ...faces } = tube(6, around, of, upward);
  const moved = positions.slice();
  if (x !== undefined) moved[0] = x;
  return { name: 'tube', ...faces, positions: moved };
}

/** Boundaries are the two loops, their key is found. */
async function merge(source: Model, target: Model, sizes: readonly [number, number], step: object) {
  const boundary = { source: upTo(sizes[0]), target: upTo(sizes[1]), keys: [] };
  const recipe = parseRecipe({
    lissom: 1,
    models: { source: { file: 's.ply' }, target: { file: 't.ply' } },
    steps: [{ id: 'm', type: 'merge', source: 'source', target: 'target', boundaries: [boundary], ...step }],
  });
  const models: Record<string, Model> = { source, target };
  const runner = new Runner({ kernel, models: { load: async (name) => models[name]! } });
  const done = meter(expect.getState().currentTestName ?? '');
  try {
    return (await runner.run(recipe)).get('m')!;
  } finally {
    done();
  }
}

describe.each(['dependent', 'independent'])('%s', (mode) => {
  test.each([
    ['source', 1e30],
    ['target', 1e30],
    ['target', -1e30],
    ['source', 1e9],
  ])('a %s with a vertex at %d is refused by name', async (side, x) => {
    const source = tubeWith(side === 'source' ? x : undefined, 40, dome);
    const target = tubeWith(side === 'target' ? x : undefined, 900, bowl, false);
    await expect(merge(source, target, [40, 900], { mode })).rejects.toMatchObject({
      code: 'boundary-too-small',
      message: expect.stringMatching(
        new RegExp(`^The ${side} boundary is too small beside its model.* vertex 0 lies .* away`),
      ),
    });
  });

  test('a vertex far away that the numbers still bear is merged, in time', async () => {
    const target = tubeWith(2000, 1500, bowl, false);
    const { model } = await merge(tubeWith(undefined, 40, dome), target, [40, 1500], { mode });
    expect(model.positions.every(Number.isFinite)).toBe(true);
  });
});

test('a source placed where its size is below the last digits is refused', async () => {
  const pose = [1e-3, 0, 0, 0, 0, 1e-3, 0, 0, 0, 0, 1e-3, 0, 1e15, 0, 0, 1];
  const models = [tubeWith(undefined, 20, dome), tubeWith(undefined, 31, bowl, false)] as const;
  await expect(merge(...models, [20, 31], { mode: 'dependent', pose })).rejects.toMatchObject({
    code: 'placed-too-far',
  });
});
