import { toJsonSchema } from '@valibot/to-json-schema';
import { expect, test } from 'vitest';
import { formatJson } from '../../web/recipe/format';
import { recipeSchema } from '../../web/recipe/recipe';
import { matrix, vec3, vertexSet } from '../../web/recipe/schema-parts';

// After a change of the schema: npx vitest run tests/recipe/schema-file.test.ts -u
test('docs/recipe.schema.json is what the schema in the code says', async () => {
  const { $schema, ...schema } = toJsonSchema(recipeSchema, {
    typeMode: 'input',
    // Checks that JSON Schema has no words for (a range's order, references) stay with parseRecipe.
    errorMode: 'ignore',
    definitions: { matrix, vec3, vertexSet },
  });
  const file = { $schema, title: 'Lissom recipe', ...schema };
  await expect(`${formatJson(file)}\n`).toMatchFileSnapshot('../../docs/recipe.schema.json');
});
