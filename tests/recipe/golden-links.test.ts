import { expect, test } from 'vitest';
import { decodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import golden from './golden-links.json' with { type: 'json' };

// Links that people have out there. Lines may be added here, never changed: whatever the format becomes, these open.
test.each(golden)('a link of version $version opens as it always did: $name', ({ link, recipe }) => {
  expect(decodeLink(link)).toStrictEqual(parseRecipe(recipe));
});
