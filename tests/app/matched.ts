// Three cubes of one connectivity, each larger than the one before, and a document that has them matched.

import type { Recipe, Step } from '../../web/recipe/recipe';
import { listed, serve } from './served';
import { CUBE_OBJ, Tab } from './world';

export const CUBES = ['ann', 'bob', 'cid'] as const;

/** Vertex i of a cube so many times as large. */
const sized = (size: number): string =>
  CUBE_OBJ.replace(/^v (\S+) (\S+) (\S+)$/gm, (_, x, y, z) => `v ${size * x} ${size * y} ${size * z}`);

/** Answers the gallery's requests: the cubes, and a coat. */
export function stubGallery(): void {
  const files: Record<string, string> = {};
  const models = [...CUBES, 'coat'].map((name, k) => {
    files[`${name}.obj`] = sized(name === 'coat' ? 1.1 : k + 1);
    return listed(name, `${name}.obj`);
  });
  files['index.json'] = JSON.stringify({ models, examples: [] });
  serve(files);
}

/** @param more  steps after the match */
export const matchedRecipe = (...more: Step[]): Recipe => ({
  lissom: 1,
  models: Object.fromEntries(CUBES.map((name) => [name, { builtin: name }])),
  steps: [
    {
      id: 'match 1',
      type: 'match',
      models: [...CUBES],
      markers: [],
      adapt: 0,
      method: 'graph',
      together: true,
      start: 'automatic',
    },
    ...more,
  ],
  outputs: [],
});

/** A tab with the three cubes matched, and the workspace entered. */
export async function matchedTab(workspace: 'blend' | 'dress'): Promise<Tab> {
  const tab = new Tab();
  await tab.app.desk.open({ recipe: matchedRecipe(), title: 'cubes' });
  await settled(tab);
  await tab.app.commands.run(`workspace.${workspace}`);
  await settled(tab);
  return tab;
}

/** What follows the result has been read as well. */
export async function settled(tab: Tab): Promise<void> {
  await tab.app.evaluator.settled();
  await new Promise((resolve) => setTimeout(resolve, 10));
}
