import * as v from 'valibot';
import { LissomError } from '../core/errors';
import { crossCheck } from './cross-checks';
import { MAX_RECIPE_BYTES } from './limits';
import { migrate } from './migrations';
import { describeIssues, oneLine, pathText, recipeError } from './problem';
import { type Recipe, recipeSchema } from './recipe';
import { grouped } from './schema-parts';

/**
 * The recipe in a file's text, or in what JSON.parse made of it, with defaults filled in.
 *
 * @throws LissomError `recipe-invalid`: one line with the place, what is wrong there and what to do;
 *                     `recipe-too-new`, `recipe-too-large`
 */
export function parseRecipe(source: unknown): Recipe {
  const document = typeof source === 'string' ? parseJson(source) : source;
  if (document === null || typeof document !== 'object' || Array.isArray(document))
    throw recipeError('', 'A recipe is a JSON object { "lissom": 1, "models": { ... }, "steps": [ ... ] }.');
  const migrated = migrate(document as Record<string, unknown>);
  refuseReserved(migrated.models);
  // All that is wrong is gathered to name the most telling; of a long text the first thing must do.
  const abortEarly = typeof source === 'string' && source.length > LONG;
  const checked = v.safeParse(recipeSchema, migrated, { abortEarly });
  if (!checked.success) throw describeIssues(checked.issues);
  crossCheck(checked.output);
  return checked.output;
}

/** Characters of a recipe that may be wrong in a hundred thousand places. */
const LONG = 1_000_000;

/** Names that every object of the language has a field of: the schema would leave such a model out without a word. */
const RESERVED = ['__proto__', 'constructor', 'prototype'];

export const isReserved = (name: string): boolean => RESERVED.includes(name);

function refuseReserved(models: unknown): void {
  if (models === null || typeof models !== 'object') return;
  const name = RESERVED.find((each) => Object.hasOwn(models, each));
  if (name !== undefined)
    throw recipeError(pathText(['models', name]), 'a model cannot have this name; choose another.');
}

function parseJson(text: string): unknown {
  if (text.length > MAX_RECIPE_BYTES)
    throw new LissomError(
      'recipe-too-large',
      `The recipe has ${grouped(text.length)} characters; the limit is ${grouped(MAX_RECIPE_BYTES)}. ` +
        'Write fewer steps, or vertex sets as ranges.',
    );
  try {
    // Editors on some systems put a byte order mark in front, which JSON does not allow.
    return JSON.parse(text.replace(/^\uFEFF/, ''));
  } catch (error) {
    throw new LissomError('recipe-invalid', notJson(text, String((error as Error).message)));
  }
}

function notJson(text: string, reason: string): string {
  if (text.trim() === '') return 'The recipe is empty; expected a JSON object.';
  const position = Number(/position (\d+)/.exec(reason)?.[1] ?? Number.NaN);
  if (position >= text.length || /end of|Unterminated/.test(reason))
    return 'The recipe ends too early, in the middle of its JSON; fetch the whole file again.';
  // Engines word it differently and some give no place.
  if (Number.isNaN(position)) return oneLine(`The recipe is not JSON: ${reason}.`);
  const before = text.slice(0, position).split('\n');
  const place = `line ${before.length}, column ${before.at(-1)!.length + 1}`;
  return `The recipe is not JSON: ${place} has an unexpected ${JSON.stringify(text[position])}.`;
}
