// Canonical JSON: equal recipes give equal text. Fields stand in the order of the schema (parseRecipe brings
// them there), models and steps in the document's own; numbers are the shortest that read back bit for bit.

import { parseRecipe } from './parse';
import type { Recipe } from './recipe';

const WIDTH = 100;

/** The text of a recipe file, ending in a newline. */
export const formatRecipe = (recipe: Recipe): string => `${formatJson(parseRecipe(recipe))}\n`;

/** JSON for people: what fits on a line stays on it, numbers fill lines, all else goes one a line. */
export function formatJson(value: unknown, indent = ''): string {
  const flat = inline(value);
  if (value === null || typeof value !== 'object' || indent.length + flat.length <= WIDTH) return flat;
  const inner = `${indent}  `;
  if (!Array.isArray(value)) {
    const fields = fieldsOf(value).map(([key, held]) => `${JSON.stringify(key)}: ${formatJson(held, inner)}`);
    return `{\n${inner}${fields.join(`,\n${inner}`)}\n${indent}}`;
  }
  const items = value.every((item) => typeof item === 'number' || isPair(item))
    ? filled(value.map(inline), WIDTH - inner.length)
    : value.map((item) => formatJson(item, inner));
  return `[\n${inner}${items.join(`,\n${inner}`)}\n${indent}]`;
}

export function inline(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(inline).join(', ')}]`;
  if (value !== null && typeof value === 'object') {
    const fields = fieldsOf(value).map(([key, held]) => `${JSON.stringify(key)}: ${inline(held)}`);
    return fields.length ? `{ ${fields.join(', ')} }` : '{}';
  }
  return Object.is(value, -0) ? '-0' : JSON.stringify(value);
}

const fieldsOf = (value: object): [string, unknown][] =>
  Object.entries(value).filter(([, held]) => held !== undefined);

/** A short run of numbers: a range, a point. */
const isPair = (value: unknown): boolean =>
  Array.isArray(value) && value.length <= 4 && value.every((item) => typeof item === 'number');

function filled(words: readonly string[], width: number): string[] {
  const lines: string[] = [];
  for (const word of words) {
    const last = lines.at(-1);
    if (last !== undefined && last.length + word.length + 2 < width)
      lines[lines.length - 1] = `${last}, ${word}`;
    else lines.push(word);
  }
  return lines;
}
