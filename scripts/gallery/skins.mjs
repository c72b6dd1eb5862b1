// What a match leaves, for scripts that pick vertices on it: run here as the app runs it, so that they are the same.

import { readFileSync } from 'node:fs';
import { openSources } from '../lib/sources.mjs';
import { folder } from './models.mjs';

/** @returns by model: positions and triangles; `levels`: where an upright body is measured */
export async function skinsOf(models, step) {
  const server = await openSources();
  try {
    const { loadKernel } = await server.ssrLoadModule('/web/kernel/node.ts');
    const { Runner } = await server.ssrLoadModule('/web/run/evaluate.ts');
    const { builtInAtOnce } = await server.ssrLoadModule('/web/io/built-in.ts');
    const { Levels } = await server.ssrLoadModule('/web/tools/blend/levels.ts');
    const { parseRecipe } = await server.ssrLoadModule('/web/recipe/parse.ts');
    const read = new Map();
    const load = async (_name, { builtin: name }) => {
      const file = `${name}.ply`;
      if (!read.has(name))
        read.set(name, builtInAtOnce({ name, file }, readFileSync(new URL(file, folder))).model);
      return read.get(name);
    };
    const runner = new Runner({ kernel: await loadKernel(), models: { load } });
    const recipe = parseRecipe(JSON.stringify({ lissom: 1, models, steps: [step], outputs: [] }));
    const found = (await runner.run(recipe)).get(step.id).models;
    const first = Object.values(found)[0];
    const levels = new Levels(first.positions, first.faceVertices, [0, 1, 0]);
    return { skins: found, levels };
  } finally {
    await server.close();
  }
}
