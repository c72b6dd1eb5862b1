// Small damage to bytes, text and JSON, of the kinds that readers have been caught by.

import type { Random } from './random';

/** Numbers at the edges of what types hold. */
const EDGES = [
  0,
  1,
  -1,
  0.5,
  2,
  3,
  127,
  128,
  255,
  256,
  65535,
  65536,
  2 ** 31 - 1,
  2 ** 31,
  2 ** 32 - 1,
  2 ** 32,
  2 ** 53 - 1,
  2 ** 53,
  1e-300,
  -1e-30,
  1e21,
  1e30,
  1e39,
  -1e39,
  1e300,
  1e308,
  -0,
];
/** Words that mean something to the language, to a file system or to nobody. */
const WORDS = [
  '',
  'constructor',
  '__proto__',
  'prototype',
  'toString',
  'a',
  '/',
  '..',
  'C:',
  'é',
  '\u0000',
  '𝔪'.repeat(70),
];
const TOKENS = [
  'nan',
  'inf',
  '-1.#IND',
  '1e999',
  '1e-999',
  '-',
  '.',
  '0x10',
  '1,5',
  '\\',
  '\t',
  '#',
  '"',
  '{',
  '\r',
];

export const edge = (random: Random): number => random.pick(EDGES);
export const word = (random: Random): string => random.pick(WORDS);

/** Bytes set, cut out, repeated, or a file that ends early; whole numbers of four bytes at the edges. */
export function mutateBytes(
  random: Random,
  file: Uint8Array,
  times = random.few(6),
): Uint8Array<ArrayBuffer> {
  let out = new Uint8Array(file);
  for (let i = 0; i < times && out.length > 0; i++) {
    const at = random.below(out.length);
    const length = Math.min(random.few(60), out.length - at);
    switch (random.below(6)) {
      case 0:
        out[at] = random.below(256);
        break;
      case 1:
        out[at]! ^= 1 << random.below(8);
        break;
      case 2:
        if (at + 4 <= out.length)
          new DataView(out.buffer, out.byteOffset).setUint32(at, edge(random) >>> 0, random.chance(0.9));
        break;
      case 3:
        out = joined(out.subarray(0, at), out.subarray(at + length));
        break;
      case 4:
        out = joined(
          out.subarray(0, at + length),
          ...random.list(random.few(9), () => out.subarray(at, at + length)),
          out.subarray(at + length),
        );
        break;
      default:
        if (random.chance(0.3)) out = out.slice(0, at);
    }
  }
  return out;
}

/** Numbers and words replaced, lines moved, repeated and left out. */
export function mutateText(random: Random, text: string): string {
  let lines = text.split('\n');
  for (let i = random.few(5); i > 0; i--) {
    const at = random.below(lines.length);
    const line = lines[at] ?? '';
    const words = line.split(' ');
    switch (random.below(5)) {
      case 0:
        lines = lines.toSpliced(at, 1);
        break;
      case 1:
        lines = lines.toSpliced(at, 0, ...random.list(random.few(30), () => line));
        break;
      case 2:
        lines[at] = lines[random.below(lines.length)] ?? '';
        break;
      default:
        words[random.below(words.length)] = random.pick([
          String(edge(random)),
          word(random),
          random.pick(TOKENS),
        ]);
        lines[at] = words.join(' ');
    }
  }
  return lines.join('\n');
}

/** A JSON value with places in it changed, left out, moved, renamed or repeated; the given one stays as it is. */
export function mutateJson(random: Random, value: unknown, times = 1 + random.few(4)): unknown {
  const root = { held: structuredClone(value) };
  for (let i = 0; i < times; i++) {
    const places = placesIn(root);
    if (places.length === 0) break;
    const { holder, key } = random.pick(places);
    const held = holder as Record<string, unknown>;
    const other = random.pick(places);
    switch (random.below(8)) {
      case 0:
        if (Array.isArray(holder)) holder.splice(Number(key), 1);
        else delete held[key];
        break;
      case 1:
        held[key] = structuredClone((other.holder as Record<string, unknown>)[other.key]);
        break;
      case 2:
        if (Array.isArray(holder))
          holder.push(...random.list(random.few(50), () => structuredClone(held[key])));
        else own(held, word(random), held[key]);
        break;
      case 3:
        held[key] = random.pick([null, true, [], {}, word(random)]);
        break;
      case 4:
        held[key] = nested(random.few(3000));
        break;
      default:
        held[key] = typeof held[key] === 'number' || random.chance(0.2) ? edge(random) : held[key];
    }
  }
  return root.held;
}

/** A JSON value that stays of its form: numbers a little or far away, items left out, repeated and turned about. */
export function tweakJson(random: Random, value: unknown, times = random.few(8)): unknown {
  const root = { held: structuredClone(value) };
  for (let i = 0; i < times; i++) {
    const places = placesIn(root);
    const { holder, key } = random.pick(places);
    const held = holder as Record<string, unknown>;
    const old = held[key];
    if (typeof old === 'number') held[key] = nearby(random, old);
    else if (typeof old === 'boolean') held[key] = !old;
    else if (Array.isArray(old) && old.length > 0) {
      const at = random.below(old.length);
      if (random.chance(0.3)) old.reverse();
      else if (random.chance(0.5)) old.splice(at, 1);
      else old.splice(at, 0, structuredClone(random.pick(old)));
    }
  }
  return root.held;
}

function nearby(random: Random, value: number): number {
  if (Number.isInteger(value) && value >= 0)
    return random.pick([0, 1, value + 1, Math.max(0, value - 1), random.below(100)]);
  const by = random.chance(0.8) ? random.between(-2, 2) : random.pick([0, 1e-12, -1e6, 1e20]);
  return value * by;
}

export const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
export const textOf = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

interface Place {
  readonly holder: object;
  readonly key: string;
}

function placesIn(root: object): Place[] {
  const places: Place[] = [];
  const open: object[] = [root];
  for (let holder = open.pop(); holder; holder = open.pop())
    for (const key of Object.keys(holder)) {
      places.push({ holder, key });
      const held = (holder as Record<string, unknown>)[key];
      if (held !== null && typeof held === 'object') open.push(held);
      if (places.length > 20_000) return places;
    }
  return places;
}

function own(holder: Record<string, unknown>, key: string, value: unknown): void {
  Object.defineProperty(holder, key, { value, enumerable: true, configurable: true, writable: true });
}

function nested(depth: number): unknown {
  let out: unknown = 1;
  for (let i = 0; i < depth; i++) out = i % 2 ? [out] : { a: out };
  return out;
}

function joined(...parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}
