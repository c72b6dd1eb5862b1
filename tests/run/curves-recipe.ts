import { parseRecipe } from '../../web/recipe/parse';
import type { Recipe } from '../../web/recipe/recipe';

/** One step `s` on the model `m`: of curves, unless it says otherwise. */
export const recipeOfStep = (step: object): Recipe =>
  parseRecipe(
    JSON.stringify({
      lissom: 1,
      models: { m: { file: 'm.ply' } },
      steps: [{ id: 's', type: 'curves', model: 'm', ...step }],
    }),
  );
