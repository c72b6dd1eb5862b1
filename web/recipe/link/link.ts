// A recipe in an address. The fragment never reaches a server.
//
//   <app>/#r=<base64url of: head, body>
//   head   version (1 byte) · check of the head (1) · length of the body (varint) · CRC-32 of the body (4, little-endian)
//   body   length once unpacked (varint) · deflate-raw of the value (value.ts)
//
// The head is the same in every version, so that a cut or damaged link is known as such before its version counts.

import { deflateSync, Inflate } from 'fflate';
import { fromBase64Url, toBase64Url } from '../../core/base64url';
import { crc32 } from '../../core/crc32';
import { LissomError } from '../../core/errors';
import { parseRecipe } from '../parse';
import type { Recipe } from '../recipe';
import { ByteReader, ByteWriter } from './bytes';
import {
  cut,
  damaged,
  emptyLink,
  linkTooNew,
  MAX_PAYLOAD,
  MAX_UNPACKED,
  MAX_VALUES,
  needsFile,
  tooLarge,
  tooManyValues,
} from './errors';
import { readValue, valuesIn, writeValue } from './value';

const VERSION = 1;
const LONGEST_HEAD = 10;
/** Packed bytes unpacked at a time: at most a thousandfold. */
const SLICE = 4096;

/**
 * The share link of a recipe, exact to the last bit of every number.
 *
 * @param base  address of the app; `''` gives the fragment alone
 * @throws LissomError `link-needs-file` for a model from a file, `link-too-large`
 */
export function encodeLink(recipe: Recipe, base = ''): string {
  refuseFiles(recipe);
  const plain = new ByteWriter();
  // The way through the schema puts fields in one order, so equal recipes give equal links.
  const ordered = parseRecipe(recipe);
  if (valuesIn(ordered) > MAX_VALUES) throw tooManyValues();
  writeValue(plain, ordered);
  const unpacked = plain.done();
  if (unpacked.length > MAX_UNPACKED)
    throw tooLarge(`The recipe needs ${unpacked.length.toLocaleString('en-US')} bytes`);
  const body = new ByteWriter();
  body.varint(unpacked.length);
  body.raw(deflateSync(unpacked, { level: 9, mem: 12 }));
  return `${base.replace(/#.*$/s, '')}#r=${toBase64Url(withHead(body.done()))}`;
}

/** Whether an address or fragment is meant to carry a recipe. */
export const hasLink = (address: string): boolean => /(^|[#&])r=/.test(address);

/**
 * The recipe of a link.
 *
 * @param address  the whole address, or its fragment
 * @throws LissomError `link-empty`, `link-cut`, `link-damaged`, `link-too-new`, `link-too-large`,
 *                     `link-needs-file`, or what parseRecipe says
 */
export function decodeLink(address: string): Recipe {
  const given = address.trim();
  const marker = /(?:^|[#&])r=/.exec(given);
  const tail = marker ? given.slice(marker.index + marker[0].length).split('&')[0]! : '';
  // Mail programs break long lines, chats put a full stop or a bracket behind.
  const joined = tail.replace(/\s+/g, '');
  const payload = joined.replace(/[^\w-]+$/, '');
  if (payload === '') throw emptyLink();
  if (payload.length > MAX_PAYLOAD) throw tooLarge('The link is longer than any that is made here');

  const { version, body } = readHead(payload, given.length);
  if (version > VERSION) throw linkTooNew();
  const recipe = parseRecipe(unpack(body));
  refuseFiles(recipe);
  return recipe;
}

function withHead(body: Uint8Array): Uint8Array {
  const length = new ByteWriter();
  length.varint(body.length);
  const out = new ByteWriter();
  out.byte(VERSION);
  out.byte(headCheck(VERSION, body.length));
  out.raw(length.done());
  const sum = crc32(body);
  for (let shift = 0; shift < 32; shift += 8) out.byte((sum >>> shift) & 255);
  out.raw(body);
  return out.done();
}

/** Without it a damaged length would read as a cut link. */
const headCheck = (version: number, length: number): number =>
  crc32(Uint8Array.of(version, length & 255, (length >>> 8) & 255, (length >>> 16) & 255)) & 255;

function readHead(payload: string, given: number): { readonly version: number; readonly body: Uint8Array } {
  const clean = /^[\w-]*/.exec(payload)![0];
  // One letter over a whole group of four holds no byte: the rest of its group was cut off.
  const whole = clean.length % 4 === 1 ? clean.slice(0, -1) : clean;
  const bytes = fromBase64Url(whole)!;
  if (bytes.length < LONGEST_HEAD && clean === payload) throw cut(given);
  const head = new ByteReader(bytes);
  const version = head.byte();
  const check = head.byte();
  const length = head.varint();
  if (check !== headCheck(version, length)) throw damaged();
  const headLength = bytes.length - head.left + 4;
  const expected = Math.ceil(((headLength + length) * 4) / 3);
  if (clean !== payload || clean.length > expected) throw damaged();
  if (clean.length < expected) throw cut(given, given + expected - clean.length);
  const sum = (head.byte() | (head.byte() << 8) | (head.byte() << 16) | (head.byte() << 24)) >>> 0;
  const body = head.rest();
  if (crc32(body) !== sum || toBase64Url(bytes) !== payload) throw damaged();
  return { version, body };
}

function unpack(body: Uint8Array): unknown {
  const from = new ByteReader(body);
  const length = from.varint();
  if (length > MAX_UNPACKED) throw tooLarge(`The link unpacks to ${length.toLocaleString('en-US')} bytes`);
  const plain = inflate(from.rest(), length);
  const reader = new ByteReader(plain);
  const value = readValue(reader);
  if (reader.left > 0) throw damaged();
  return value;
}

/** In slices, so that a link which unpacks to far more than it says is stopped on the way, not after it. */
function inflate(packed: Uint8Array, length: number): Uint8Array {
  const plain = new Uint8Array(length);
  let filled = 0;
  const stream = new Inflate((chunk) => {
    if (filled + chunk.length > length) throw tooLarge('The link unpacks to more than it says');
    plain.set(chunk, filled);
    filled += chunk.length;
  });
  try {
    for (let at = 0; at < packed.length; at += SLICE)
      stream.push(packed.subarray(at, at + SLICE), at + SLICE >= packed.length);
  } catch (error) {
    throw error instanceof LissomError ? error : damaged();
  }
  if (filled < length) throw damaged();
  return plain;
}

function refuseFiles(recipe: Recipe): void {
  for (const [name, ref] of Object.entries(recipe.models)) if ('file' in ref) throw needsFile(name, ref.file);
}
