// Fruit that are alike enough to be matched, a belt around one of them, and a match of the two on the real kernel.

import type { Model } from '../../web/core/model';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import type { Recipe } from '../../web/recipe/recipe';
import { Runner } from '../../web/run/evaluate';
import { belt, fig, pear, plum } from '../kernel/balls';

export const FRUIT = { pear: pear(), plum: plum(), fig: fig(), belt: belt(1.05) };

/** The ends of the axes, so many of them. */
export const marks = (count = 6): number[][] =>
  FRUIT.pear.ends.slice(0, count).map((vertex, at) => [vertex, FRUIT.plum.ends[at]!]);

/** A pear and a plum. */
export const match = (more: object = {}) => ({
  id: 'm',
  type: 'match',
  models: ['pear', 'plum'],
  markers: marks(),
  edgeLength: 0.3,
  ...more,
});

export const recipeOf = (...steps: unknown[]): Recipe =>
  parseRecipe({
    lissom: 1,
    models: Object.fromEntries(Object.keys(FRUIT).map((name) => [name, { builtin: name }])),
    steps,
  });

export async function fruitRunner(): Promise<Runner> {
  const loaded = new Map<string, Model>(
    Object.entries(FRUIT).map(([name, shape]) => [name, { name, ...shape }]),
  );
  return new Runner({
    kernel: await loadKernel(),
    models: { load: async (name) => loaded.get(name)! },
  });
}
