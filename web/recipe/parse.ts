import * as v from 'valibot';
import { LissomError } from '../core/errors';
import { crossCheck } from './cross-checks';
import { migrate } from './migrations';
import { describeIssues, oneLine, recipeError } from './problem';
import { type Recipe, recipeSchema } from './recipe';

/**
 * The recipe in a file's text, or in what JSON.parse made of it, with defaults filled in.
 *
 * @throws LissomError `recipe-invalid`: one line with the place, what is wrong there and what to do;
 *                     `recipe-too-new`
 */
export function parseRecipe(source: unknown): Recipe {
  const document = typeof source === 'string' ? parseJson(source) : source;
  if (document === null || typeof document !== 'object' || Array.isArray(document))
    throw recipeError('', 'A recipe is a JSON object { "lissom": 1, "models": { ... }, "steps": [ ... ] }.');
  const checked = v.safeParse(recipeSchema, migrate(document as Record<string, unknown>));
  if (!checked.success) throw describeIssues(checked.issues);
  crossCheck(checked.output);
  return checked.output;
}

function parseJson(text: string): unknown {
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
