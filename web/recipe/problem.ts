// What the schema found wrong, as one line for a person: where, what, what to do.

import type * as v from 'valibot';
import { LissomError } from '../core/errors';
import { STEP_TYPES, type StepType, stepRow } from './recipe';

type Issue = v.BaseIssue<unknown>;

const KNOWN_TYPES = Object.keys(STEP_TYPES);

/** An error about one place of a recipe. */
export const recipeError = (path: string, message: string, code = 'recipe-invalid'): LissomError =>
  new LissomError(code, oneLine(path ? `${path}: ${message}` : message));

/** The most telling of the schema's issues: a misspelt field explains the missing one beside it. */
export function describeIssues(issues: readonly Issue[]): LissomError {
  const issue = issues.find(isUnknownField) ?? issues[0]!;
  const more = issues.length > 1 ? ` (and ${issues.length - 1} more)` : '';
  return recipeError(pathOf(issue), sentence(issue) + more);
}

/** `steps[0].handles[1].matrix`; names that are not plain words stand quoted. */
export function pathText(path: readonly (string | number)[]): string {
  return path.reduce<string>((text, key) => {
    if (typeof key === 'number') return `${text}[${key}]`;
    if (!/^[A-Za-z_][\w-]*$/.test(key)) return `${text}[${JSON.stringify(key)}]`;
    return text ? `${text}.${key}` : key;
  }, '');
}

function sentence(issue: Issue): string {
  if (isUnknownField(issue)) {
    const known = knownFields(issue);
    return `unknown field ${JSON.stringify(issue.input)}; ${known ? `the fields here are ${known}` : 'remove it'}.`;
  }
  if (isMissing(issue)) return `the field ${issue.expected} is missing; add it.`;
  if (issue.type === 'variant' && issue.path?.at(-1)?.key === 'type')
    return `unknown step type ${shown(issue.input)}; known types are ${KNOWN_TYPES.join(', ')}.`;
  return `expected ${expectation(issue)}, found ${shown(issue.input)}.`;
}

function expectation(issue: Issue): string {
  if (!issue.message.startsWith('Invalid ')) return issue.message;
  return PLAIN[issue.expected ?? ''] ?? issue.expected ?? 'something else';
}

const PLAIN: Readonly<Record<string, string>> = {
  Object: 'an object { ... }',
  string: 'a text',
  number: 'a number',
  boolean: 'true or false',
};

const isUnknownField = (issue: Issue): boolean =>
  issue.type === 'strict_object' && issue.expected === 'never';

const isMissing = (issue: Issue): boolean =>
  issue.type === 'strict_object' && issue.path?.at(-1)?.origin === 'key' && issue.expected !== 'never';

const pathOf = (issue: Issue): string =>
  pathText((issue.path ?? []).map(({ key }) => key as string | number));

/** The fields of the object an unknown one was found in, where the schema can be followed to it. */
function knownFields(issue: Issue): string | undefined {
  const parent = issue.path?.at(-1)?.input as { readonly type?: unknown } | undefined;
  if (issue.path?.length !== 3 || !KNOWN_TYPES.includes(String(parent?.type))) return undefined;
  return Object.keys(stepRow(parent?.type as StepType).schema.entries).join(', ');
}

function shown(value: unknown): string {
  if (value === undefined) return 'nothing';
  if (Array.isArray(value)) return value.length === 1 ? 'a list of 1' : `a list of ${value.length}`;
  if (value !== null && typeof value === 'object')
    return `an object with ${Object.keys(value).join(', ') || 'no fields'}`;
  const text = typeof value === 'string' ? JSON.stringify(value) : String(value);
  return text.length > 60 ? `${text.slice(0, 57)}...` : text;
}

/** Whatever a name may hold, the message stays one line. */
export function oneLine(text: string): string {
  return text.replace(/[\p{Cc}\p{Zl}\p{Zp}]+/gu, ' ');
}
