// Text inside a PNG picture: an iTXt chunk, which every viewer passes over (PNG specification, third edition, 11.3.3.4).

import { crc32 } from '../core/crc32';
import { LissomError } from '../core/errors';
import { checkSize } from './budget';

const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10];
/** Length, type and check of a chunk. */
const FRAME = 12;

export const isPng = (bytes: Uint8Array): boolean => SIGNATURE.every((byte, i) => bytes[i] === byte);

/**
 * The picture with a text in it, before the chunk that ends it. One already there under that keyword is replaced.
 *
 * @param keyword  1 to 79 characters of ASCII
 * @throws LissomError `picture-damaged`
 */
export function withPngText(png: Uint8Array, keyword: string, text: string): Uint8Array<ArrayBuffer> {
  const kept = chunksOf(png, 'the picture').filter((chunk) => keywordOf(chunk) !== keyword);
  const parts = kept.map(({ whole }) => whole);
  parts.splice(-1, 0, textChunk(keyword, text));
  const out = new Uint8Array(SIGNATURE.length + parts.reduce((sum, { length }) => sum + length, 0));
  out.set(SIGNATURE);
  let at = SIGNATURE.length;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/**
 * @param file  name for messages
 * @returns the text under a keyword; `undefined` where the picture has none
 * @throws LissomError `picture-damaged`: not a PNG, cut short, or its text altered; `file-too-large`
 */
export function pngText(png: Uint8Array, file: string, keyword: string): string | undefined {
  checkSize('picture', file, png.length);
  const chunk = chunksOf(png, file).find((each) => keywordOf(each) === keyword);
  if (!chunk) return undefined;
  const { whole, data } = chunk;
  const said = viewOf(whole).getUint32(whole.length - 4);
  if (crc32(whole.subarray(4, -4)) !== said) throw damaged(file, 'the text in it does not match its check');
  // Keyword, 0, packed?, method, language, 0, translated keyword, 0, text.
  const packed = data[keyword.length + 1];
  let at = keyword.length + 3;
  for (let skipped = 0; skipped < 2 && at < data.length; at++) if (data[at] === 0) skipped++;
  if (packed !== 0) throw damaged(file, 'another program has repacked the text in it');
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(data.subarray(at));
  } catch {
    throw damaged(file, 'the text in it is no text');
  }
}

interface Chunk {
  readonly type: string;
  /** With length, type and check. */
  readonly whole: Uint8Array;
  readonly data: Uint8Array;
}

function chunksOf(png: Uint8Array, file: string): Chunk[] {
  if (!isPng(png)) throw damaged(file, 'it does not begin as a PNG picture does');
  const view = viewOf(png);
  const chunks: Chunk[] = [];
  for (let at = SIGNATURE.length; chunks.at(-1)?.type !== 'IEND'; ) {
    const length = at + FRAME <= png.length ? view.getUint32(at) : Infinity;
    if (at + FRAME + length > png.length) throw damaged(file, 'it ends in the middle');
    const whole = png.subarray(at, at + FRAME + length);
    const type = String.fromCharCode(...whole.subarray(4, 8));
    chunks.push({ type, whole, data: whole.subarray(8, -4) });
    at += whole.length;
  }
  return chunks;
}

function keywordOf({ type, data }: Chunk): string | undefined {
  if (type !== 'iTXt') return undefined;
  return String.fromCharCode(...data.subarray(0, Math.max(0, data.subarray(0, 80).indexOf(0))));
}

function textChunk(keyword: string, text: string): Uint8Array {
  const data = new TextEncoder().encode(`iTXt${keyword}\0\0\0\0\0${text}`);
  const chunk = new Uint8Array(data.length + 8);
  const view = viewOf(chunk);
  view.setUint32(0, data.length - 4);
  chunk.set(data, 4);
  view.setUint32(chunk.length - 4, crc32(data));
  return chunk;
}

const viewOf = ({ buffer, byteOffset, byteLength }: Uint8Array): DataView =>
  new DataView(buffer, byteOffset, byteLength);

function damaged(file: string, what: string): LissomError {
  const message = `${file} is damaged: ${what}. Send the picture as a file; chats and websites often shrink what is sent as a picture.`;
  return new LissomError('picture-damaged', message);
}
