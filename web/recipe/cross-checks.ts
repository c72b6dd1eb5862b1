// What a schema cannot say: names that must be unique, references that must lead somewhere.

import { pathText, recipeError } from './problem';
import { outputExtensions, type Recipe, type Step, stepSchema } from './recipe';
import { reference } from './schema-parts';

/** One place where a step names a model or an earlier step. */
export interface Reference {
  readonly path: readonly (string | number)[];
  readonly name: string;
}

/** The references of a step, found through its schema: fields declared as `reference` or as a list of them. */
export function referencesOf(step: Step): readonly Reference[] {
  const schema = stepSchema.options.find((option) => option.entries.type.literal === step.type);
  const found: Reference[] = [];
  for (const [field, held] of Object.entries(step)) {
    const declared: unknown = schema?.entries[field as keyof typeof schema.entries];
    if (declared === reference) found.push({ path: [field], name: held as string });
    else if (isReferenceList(declared))
      for (const [at, name] of (held as unknown as readonly string[]).entries())
        found.push({ path: [field, at], name });
  }
  return found;
}

/** @throws LissomError `recipe-invalid` */
export function crossCheck(recipe: Recipe): void {
  const known = new Set(Object.keys(recipe.models));
  const ids = new Set<string>();
  for (const [at, step] of recipe.steps.entries()) {
    for (const { path, name } of referencesOf(step))
      if (!known.has(name))
        throw recipeError(pathText(['steps', at, ...path]), lost(name, recipe, at, known));
    if (known.has(step.id)) {
      const what = ids.has(step.id) ? 'an earlier step' : 'a model';
      throw recipeError(
        pathText(['steps', at, 'id']),
        `${quoted(step.id)} is the name of ${what} too; choose another id.`,
      );
    }
    known.add(step.id);
    ids.add(step.id);
  }
  checkOutputs(recipe, ids);
}

function checkOutputs({ outputs, steps }: Recipe, ids: ReadonlySet<string>): void {
  const files = new Set<string>();
  for (const [at, { step, file }] of outputs.entries()) {
    const wrong = (field: string, message: string) => recipeError(pathText(['outputs', at, field]), message);
    const made = steps.find(({ id }) => id === step);
    if (!made) throw wrong('step', `there is no step ${quoted(step)}; the steps are ${listed(ids)}.`);
    const known = outputExtensions(made.type);
    if (!known.includes(extensionOf(file)))
      throw wrong(
        'file',
        `cannot write ${quoted(file)}; end its name in ${known.map((extension) => `.${extension}`).join(', ')}.`,
      );
    if (files.has(file)) throw wrong('file', `${quoted(file)} is written twice; choose another name.`);
    files.add(file);
  }
}

/** In lower case and without the dot; empty where there is none. */
export const extensionOf = (file: string): string => /\.([^./\\]+)$/.exec(file)?.[1]?.toLowerCase() ?? '';

function lost(name: string, recipe: Recipe, at: number, known: ReadonlySet<string>): string {
  const later = recipe.steps.findIndex((step) => step.id === name);
  if (later === at) return `${quoted(name)} is the step itself; name a model or an earlier step.`;
  if (later > at) return `${quoted(name)} is a later step (steps[${later}]); move it before this one.`;
  return `there is no model or earlier step ${quoted(name)}; there are ${listed(known)}.`;
}

const isReferenceList = (schema: unknown): boolean =>
  (schema as { readonly item?: unknown } | undefined)?.item === reference;

const quoted = (text: string): string => JSON.stringify(text);
const listed = (names: ReadonlySet<string>): string => [...names].map(quoted).join(', ') || 'none';
