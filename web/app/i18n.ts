// All words the user sees are in locales/en/*.json, under typed keys. `{name}` in a message is filled from `params`.
// A wing's own words come with the wing (`addWords`); until then there is nothing on screen that needs them.

import app from './locales/en/app.json';
import type blend from './locales/en/blend.json';
import type curves from './locales/en/curves.json';
import type deform from './locales/en/deform.json';
import type dress from './locales/en/dress.json';
import type hair from './locales/en/hair.json';
import type match from './locales/en/match.json';
import type merge from './locales/en/merge.json';
import type transfer from './locales/en/transfer.json';
import ui from './locales/en/ui.json';
import wings from './locales/en/wings.json';

/** One name per wing: the registry of words. */
type WingWords = typeof blend &
  typeof curves &
  typeof deform &
  typeof dress &
  typeof hair &
  typeof match &
  typeof merge &
  typeof transfer;
type Words = typeof app & typeof ui & WingWords;
type WingId = keyof typeof wings;

/** What a wing is called before it is loaded: on its button, among the commands, over its examples in the gallery. */
const names = Object.fromEntries(
  Object.entries(wings).flatMap(([id, words]) =>
    Object.entries(words).map(([part, name]) => [`wing.${id}.${part}`, name]),
  ),
);
const en: Record<string, string> = { ...app, ...ui, ...names };

export type MessageKey = keyof Words | `wing.${WingId}.${keyof (typeof wings)[WingId]}`;
export type Params = Readonly<Record<string, string | number>>;

export function addWords(words: Readonly<Record<string, string>>): void {
  Object.assign(en, words);
}

/** The message under `key`, its `{placeholders}` filled in; numbers in the reader's own notation. */
export function t(key: MessageKey, params: Params = {}): string {
  return fill(en[key] ?? key, params);
}

/** The message under `prefix` + `code`, or under `fallback` for a code that has no message of its own. */
export function tCode(prefix: string, code: string, fallback: MessageKey, params: Params = {}): string {
  const message = Object.hasOwn(en, prefix + code) ? en[prefix + code] : undefined;
  return message === undefined ? t(fallback, { code, ...params }) : fill(message, params);
}

const NUMBER = new Intl.NumberFormat('en-US', { maximumSignificantDigits: 6 });

export const formatNumber = (value: number): string => NUMBER.format(value);

/** `{name}` is a parameter; `{count|vertex|vertices}` a number with the word for one or for more. */
function fill(message: string, params: Params): string {
  return message.replace(
    /\{(\w+)(?:\|([^|}]*)\|([^}]*))?\}/g,
    (whole, name: string, one?: string, more?: string) => {
      const value = params[name];
      if (value === undefined) return whole;
      const text = typeof value === 'number' ? formatNumber(value) : value;
      return one === undefined ? text : `${text} ${value === 1 ? one : more}`;
    },
  );
}
