// A picture that carries what it shows: the recipe as text inside the PNG.

import { LissomError } from '../core/errors';
import { pngText, withPngText } from '../io/png-text';
import { formatRecipe } from '../recipe/format';
import { parseRecipe } from '../recipe/parse';
import type { Recipe } from '../recipe/recipe';
import { t } from './i18n';

const KEYWORD = 'lissom:recipe';

/** @param recipe  `null` for a picture of something else */
export const pictureOf = (png: Uint8Array, recipe: Recipe | null): Uint8Array =>
  recipe ? withPngText(png, KEYWORD, formatRecipe(recipe)) : png;

/** @throws LissomError `picture-damaged`, `picture-without-recipe`, and what is wrong with the recipe */
export function recipeOf(png: Uint8Array, name: string): Recipe {
  const text = pngText(png, name, KEYWORD);
  if (text === undefined)
    throw new LissomError('picture-without-recipe', t('error.picture-without-recipe', { name }));
  return parseRecipe(text);
}
