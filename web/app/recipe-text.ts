// A recipe's text as autosave keeps it: one line of JSON, exact to the bit, made once for each recipe.

import { inline } from '../recipe/format';
import type { Recipe } from '../recipe/recipe';
import { sha256 } from './model-store';

export interface HashedText {
  readonly hash: string;
  readonly bytes: Uint8Array;
}

/** Recipes never change in place. */
const texts = new WeakMap<Recipe, string>();
const hashed = new WeakMap<Recipe, Promise<HashedText>>();

export function recipeText(recipe: Recipe): string {
  let text = texts.get(recipe);
  if (text === undefined) {
    // The engine's own writer is some fourteen times as fast, but it loses the sign of zero.
    text = hasNegativeZero(recipe) ? inline(recipe) : JSON.stringify(recipe);
    texts.set(recipe, text);
  }
  return text;
}

/** Where it is kept, and what. */
export function hashedText(recipe: Recipe): Promise<HashedText> {
  let text = hashed.get(recipe);
  if (!text) {
    const bytes = new TextEncoder().encode(recipeText(recipe));
    text = sha256(bytes).then((hash) => ({ hash, bytes }));
    hashed.set(recipe, text);
  }
  return text;
}

function hasNegativeZero(value: unknown): boolean {
  if (typeof value === 'number') return Object.is(value, -0);
  if (value === null || typeof value !== 'object') return false;
  for (const held of Array.isArray(value) ? value : Object.values(value))
    if (hasNegativeZero(held)) return true;
  return false;
}
