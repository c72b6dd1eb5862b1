// All words the user sees are in locales/en*.json, under typed keys. `{name}` in a message is filled from `params`.

import words from './locales/en.json';
import ui from './locales/en.ui.json';

const en = { ...words, ...ui };

export type MessageKey = keyof typeof en;
export type Params = Readonly<Record<string, string | number>>;

/** The message under `key`, its `{placeholders}` filled in; numbers in the reader's own notation. */
export function t(key: MessageKey, params: Params = {}): string {
  return fill(en[key], params);
}

/** The message under `prefix` + `code`, or under `fallback` for a code that has no message of its own. */
export function tCode(prefix: string, code: string, fallback: MessageKey, params: Params = {}): string {
  const key = `${prefix}${code}`;
  return Object.hasOwn(en, key) ? fill(en[key as MessageKey], params) : t(fallback, { code, ...params });
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
