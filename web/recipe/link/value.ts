// Any JSON value as bytes and back. Driven by the shape of the value alone, so a new step type needs nothing
// here: lists of numbers and lists of equally long lists of numbers (points, ranges) take the short way.

import type { ByteReader, ByteWriter } from './bytes';
import { damaged, linkTooNew, MAX_VALUES, tooManyValues } from './errors';
import { readNumber, readNumbers, writeNumber, writeNumbers } from './numbers';
import { WORDS } from './words';

const NULL = 0;
const FALSE = 1;
const TRUE = 2;
const TEXT = 3;
const NUMBER = 4;
const LIST = 5;
const OBJECT = 6;
const NUMBERS = 7;
const TABLE = 8;

/** Deeper than any recipe, shallower than the stack. */
const MAX_DEPTH = 40;

/** What a list, a table's row or an object takes beside what is in it, in values of eight bytes. */
const HOLDER = 6;
/** Characters that fit where a number does. */
const LETTERS = 4;

const CODES = new Map(WORDS.map((word, code) => [word, code]));

/** What a value takes once it is read, in values of eight bytes: what a writer asks before it makes a link. */
export function valuesIn(value: unknown): number {
  if (typeof value === 'string') return lettersTake(value.length);
  if (value === null || typeof value !== 'object') return 1;
  let sum = HOLDER;
  for (const [key, held] of Object.entries(value))
    if (held !== undefined) sum += valuesIn(held) + (Array.isArray(value) ? 0 : lettersTake(key.length));
  return sum;
}

const lettersTake = (length: number): number => 1 + Math.ceil(length / LETTERS);

/** Counts what is read before it is set aside. */
export class ValueBudget {
  #left = MAX_VALUES;

  /** @throws LissomError `link-too-large` */
  take(values: number): void {
    this.#left -= values;
    if (this.#left < 0) throw tooManyValues();
  }
}

/** @param value  JSON: finite numbers, texts, lists, plain objects; fields that are `undefined` are left out */
export function writeValue(out: ByteWriter, value: unknown): void {
  if (typeof value === 'number') {
    out.byte(NUMBER);
    writeNumber(out, value);
  } else if (typeof value === 'string') {
    out.byte(TEXT);
    writeText(out, value);
  } else if (Array.isArray(value)) writeList(out, value);
  else if (value !== null && typeof value === 'object') {
    const fields = Object.entries(value).filter(([, held]) => held !== undefined);
    out.byte(OBJECT);
    out.varint(fields.length);
    for (const [key, held] of fields) {
      writeText(out, key);
      writeValue(out, held);
    }
  } else out.byte(value === true ? TRUE : value === false ? FALSE : NULL);
}

/** @throws LissomError `link-damaged`, `link-too-new`, `link-too-large` */
export function readValue(from: ByteReader, budget = new ValueBudget(), depth = 0): unknown {
  if (depth > MAX_DEPTH) throw damaged();
  const kind = from.byte();
  if (kind === LIST || kind === OBJECT) return readHolder(from, kind, budget, depth);
  if (kind === NUMBERS || kind === TABLE) return readTable(from, kind, budget);
  if (kind === TEXT) return readText(from, budget);
  budget.take(1);
  if (kind === NULL) return null;
  if (kind === FALSE || kind === TRUE) return kind === TRUE;
  if (kind === NUMBER) return readNumber(from);
  throw linkTooNew();
}

function readHolder(from: ByteReader, kind: number, budget: ValueBudget, depth: number): unknown {
  budget.take(HOLDER);
  const item = () => readValue(from, budget, depth + 1);
  if (kind === LIST) return Array.from({ length: from.count() }, item);
  const fields = Array.from({ length: from.count(2) }, () => [readText(from, budget), item()] as const);
  return Object.fromEntries(fields);
}

function writeList(out: ByteWriter, items: readonly unknown[]): void {
  const width = tableWidth(items);
  if (items.length > 0 && items.every(isNumber)) {
    out.byte(NUMBERS);
    out.varint(items.length);
    writeNumbers(out, items, 1);
  } else if (width > 0) {
    out.byte(TABLE);
    out.varint(items.length);
    out.varint(width);
    writeNumbers(out, items.flat() as number[], width);
  } else {
    out.byte(LIST);
    out.varint(items.length);
    for (const item of items) writeValue(out, item);
  }
}

/** Numbers alone, or in rows. A row is a byte at least: rows of no numbers would be made of nothing. */
function readTable(from: ByteReader, kind: number, budget: ValueBudget): number[] | number[][] {
  const rows = from.count();
  const width = kind === TABLE ? from.count() : 1;
  if (width === 0) throw damaged();
  budget.take(kind === TABLE ? HOLDER + rows * (HOLDER + width) : HOLDER + rows);
  const flat = readNumbers(from, rows * width, width);
  if (kind === NUMBERS) return flat;
  return Array.from({ length: rows }, (_, row) => flat.slice(row * width, (row + 1) * width));
}

/** Columns, where every item is a list of equally many numbers; else 0. */
function tableWidth(items: readonly unknown[]): number {
  const first = items[0];
  if (!Array.isArray(first)) return 0;
  const fits = (item: unknown) => Array.isArray(item) && item.length === first.length && item.every(isNumber);
  return items.every(fits) ? first.length : 0;
}

const isNumber = (value: unknown): value is number => typeof value === 'number';

/** A known word as an even number; any other text as an odd one, its length, and its UTF-16 units. */
function writeText(out: ByteWriter, text: string): void {
  const code = CODES.get(text);
  out.varint(code === undefined ? 2 * text.length + 1 : 2 * code);
  if (code === undefined) for (let i = 0; i < text.length; i++) out.varint(text.charCodeAt(i));
}

function readText(from: ByteReader, budget: ValueBudget): string {
  const code = from.varint();
  if (code % 2 === 0) {
    const word = WORDS[code / 2];
    if (word === undefined) throw linkTooNew();
    budget.take(lettersTake(word.length));
    return word;
  }
  const length = (code - 1) / 2;
  if (length > from.left) throw damaged();
  budget.take(lettersTake(length));
  let text = '';
  for (let i = 0; i < length; i++) {
    const unit = from.varint();
    if (unit > 0xffff) throw damaged();
    text += String.fromCharCode(unit);
  }
  return text;
}
