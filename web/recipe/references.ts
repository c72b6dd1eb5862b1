// Who names whom: what a step starts from, and the names of what it leaves.

import { type Recipe, type Step, stepRow } from './recipe';
import { reference, severalReference } from './schema-parts';

/** One place where a step names a model or an earlier step. */
export interface Reference {
  readonly path: readonly (string | number)[];
  readonly name: string;
  /** Of a step that leaves several models: all of them. */
  readonly several?: true;
}

/** The references of a step, found through its schema: fields declared as `reference`, as a list of them, or as `severalReference`. */
export function referencesOf(step: Step): readonly Reference[] {
  const { entries } = stepRow(step.type).schema;
  const found: Reference[] = [];
  for (const [field, held] of Object.entries(step)) {
    const declared = withoutDefault(entries[field]);
    if (held === undefined) continue;
    if (declared === severalReference) found.push({ path: [field], name: held as string, several: true });
    else if (declared === reference) found.push({ path: [field], name: held as string });
    else if (isReferenceList(declared))
      for (const [at, name] of (held as unknown as readonly string[]).entries())
        found.push({ path: [field, at], name });
  }
  return found;
}

/** Number, among a step's references, of the model that it changes. */
export function mainReference(step: Step): number {
  const { main } = stepRow(step.type);
  return referencesOf(step).findIndex(({ path: [field] }) => field === main);
}

/** Name of the model that a step changes: what its result takes the place of. */
export const mainInput = (step: Step): string => referencesOf(step)[mainReference(step)]!.name;

/** What models and outputs call the result of a step: its id, or `<id>/<name>` for each of several. */
export const producedNames = (step: Step): readonly string[] =>
  stepRow(step.type)
    .outputs?.(step)
    .map((name) => `${step.id}/${name}`) ?? [step.id];

/** All names that a step takes. */
export const namesOf = (step: Step): ReadonlySet<string> => new Set([step.id, ...producedNames(step)]);

/** The step that leaves something under a name. */
export const producerOf = ({ steps }: Pick<Recipe, 'steps'>, name: string): Step | undefined =>
  steps.find((step) => producedNames(step).includes(name));

/** The last part of `<id>/<name>`; empty for what is called by the step's id. */
export const outputName = ({ id }: Step, name: string): string => name.slice(id.length + 1);

const withoutDefault = (schema: unknown): unknown =>
  (schema as { readonly wrapped?: unknown } | undefined)?.wrapped ?? schema;

const isReferenceList = (schema: unknown): boolean =>
  (schema as { readonly item?: unknown } | undefined)?.item === reference;
