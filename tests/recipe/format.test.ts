import fc from 'fast-check';
import { expect, test } from 'vitest';
import { formatRecipe } from '../../web/recipe/format';
import { parseRecipe } from '../../web/recipe/parse';
import type { DeformStep } from '../../web/recipe/recipe';
import { anyRecipe, example } from './arbitraries';

test('a recipe written and read is the same to the last bit', () => {
  fc.assert(
    fc.property(anyRecipe, (recipe) => {
      expect(parseRecipe(formatRecipe(recipe))).toStrictEqual(recipe);
    }),
  );
});

test('writing again gives the same text', () => {
  fc.assert(
    fc.property(anyRecipe, (recipe) => {
      const text = formatRecipe(recipe);
      expect(formatRecipe(parseRecipe(text))).toBe(text);
    }),
  );
});

test('the order in which fields were given does not show', () => {
  const { steps, ...rest } = example();
  const shuffled = {
    steps: steps.map((step) => Object.fromEntries(Object.entries(step).reverse())),
    ...rest,
  };
  expect(formatRecipe(parseRecipe(shuffled))).toBe(formatRecipe(parseRecipe(example())));
});

test('the text is for reading: short things stay on their line, numbers fill theirs', () => {
  const recipe = parseRecipe(example());
  const step = recipe.steps[0] as DeformStep;
  step.roi = Array.from({ length: 60 }, (_, i) => 100 + 2 * i);
  expect(formatRecipe(recipe)).toMatchInlineSnapshot(`
    "{
      "lissom": 1,
      "models": { "bar": { "builtin": "bar" } },
      "steps": [
        {
          "id": "bend",
          "type": "deform",
          "model": "bar",
          "roi": [
            100, 102, 104, 106, 108, 110, 112, 114, 116, 118, 120, 122, 124, 126, 128, 130, 132, 134,
            136, 138, 140, 142, 144, 146, 148, 150, 152, 154, 156, 158, 160, 162, 164, 166, 168, 170,
            172, 174, 176, 178, 180, 182, 184, 186, 188, 190, 192, 194, 196, 198, 200, 202, 204, 206,
            208, 210, 212, 214, 216, 218
          ],
          "handles": [
            {
              "kind": "region",
              "vertices": { "ranges": [[0, 80]] },
              "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
            },
            {
              "kind": "region",
              "vertices": [1950, 1951],
              "matrix": [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 2, 1, 1]
            },
            { "kind": "point", "vertices": [977], "position": [0.1, 0.4, 2] }
          ],
          "method": "implicit",
          "options": { "removeShear": true, "scaleDetails": false, "iterations": 1, "coherenceRing": 1 }
        }
      ],
      "outputs": [{ "step": "bend", "file": "bent.ply" }]
    }
    "
  `);
});
