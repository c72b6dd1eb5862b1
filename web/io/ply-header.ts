import { LissomError } from '../core/errors';
import { decode } from './text-scanner';

export type PlyType = 'char' | 'uchar' | 'short' | 'ushort' | 'int' | 'uint' | 'float' | 'double';

export interface PlyProperty {
  readonly name: string;
  readonly type: PlyType;
  /** Set for lists: the type of the length before the values. */
  readonly countType?: PlyType;
}

export interface PlyElement {
  readonly name: string;
  readonly count: number;
  readonly properties: readonly PlyProperty[];
}

export interface PlyHeader {
  readonly encoding: 'ascii' | 'little' | 'big';
  readonly elements: readonly PlyElement[];
  readonly comments: readonly string[];
  /** First byte after the header, and its line. */
  readonly dataStart: number;
  readonly dataLine: number;
}

export const PLY_BYTES: Readonly<Record<PlyType, number>> = {
  char: 1,
  uchar: 1,
  short: 2,
  ushort: 2,
  int: 4,
  uint: 4,
  float: 4,
  double: 8,
};

// Maps, not objects: a file may well say “constructor”, which every object has.
const TYPES = new Map<string, PlyType>([
  ...(Object.keys(PLY_BYTES) as PlyType[]).map((type) => [type, type] as const),
  ['int8', 'char'],
  ['uint8', 'uchar'],
  ['int16', 'short'],
  ['uint16', 'ushort'],
  ['int32', 'int'],
  ['uint32', 'uint'],
  ['float32', 'float'],
  ['float64', 'double'],
]);

const ENCODINGS = new Map<string, PlyHeader['encoding']>([
  ['ascii', 'ascii'],
  ['binary_little_endian', 'little'],
  ['binary_big_endian', 'big'],
]);

/** A header longer than this is none. */
const LONGEST = 1 << 20;

/** @throws LissomError `file-truncated` without `end_header`, `file-damaged` for a line that makes no sense */
export function readPlyHeader(bytes: Uint8Array, file: string): PlyHeader {
  let encoding: PlyHeader['encoding'] | undefined;
  const elements: (PlyElement & { properties: PlyProperty[] })[] = [];
  const comments: string[] = [];
  let at = 0;
  for (let line = 1; ; line++) {
    const end = lineEnd(bytes, at);
    if (end === undefined) throw headerCutShort(file, line);
    const text = decode(bytes, at, end).trim();
    at = bytes[end] === 13 && bytes[end + 1] === 10 ? end + 2 : end + 1;
    const [keyword, ...words] = text.split(/\s+/);
    const fail = () => damaged(file, line, text);
    switch (keyword) {
      case 'format':
        encoding = ENCODINGS.get(words[0] ?? '');
        if (!encoding) throw fail();
        break;
      case 'comment':
      case 'obj_info':
        comments.push(text.slice(keyword.length).trim());
        break;
      case 'element': {
        const count = Number(words[1]);
        if (!words[0] || !Number.isInteger(count) || count < 0) throw fail();
        elements.push({ name: words[0], count, properties: [] });
        break;
      }
      case 'property': {
        const property = readProperty(words);
        const element = elements.at(-1);
        if (!property || !element) throw fail();
        element.properties.push(property);
        break;
      }
      case 'end_header':
        if (!encoding) throw fail();
        return { encoding, elements, comments, dataStart: at, dataLine: line + 1 };
      case 'ply':
      case '':
        break;
      default:
        throw fail();
    }
  }
}

function readProperty(words: readonly string[]): PlyProperty | undefined {
  if (words[0] === 'list') {
    const countType = TYPES.get(words[1] ?? '');
    const type = TYPES.get(words[2] ?? '');
    return countType && type && words[3] ? { name: words[3], type, countType } : undefined;
  }
  const type = TYPES.get(words[0] ?? '');
  return type && words[1] ? { name: words[1], type } : undefined;
}

/** A CR at the very end may be half of a CR LF whose rest is missing: that counts as no line end. */
function lineEnd(bytes: Uint8Array, from: number): number | undefined {
  const limit = Math.min(bytes.length, LONGEST);
  for (let at = from; at < limit; at++) if (bytes[at] === 10 || bytes[at] === 13) return at;
  // A file without elements may end right after its last word.
  return decode(bytes, from, Math.min(limit, from + 12)) === 'end_header' ? limit : undefined;
}

function headerCutShort(file: string, line: number): LissomError {
  const message = `${file} ends within its header, at line ${line}: “end_header” is missing. It was cut short: fetch it again.`;
  return new LissomError('file-truncated', message);
}

function damaged(file: string, line: number, text: string): LissomError {
  const shown = text.length > 60 ? `${text.slice(0, 60)}…` : text;
  const message = `The header of ${file} makes no sense at line ${line}: “${shown}”. Export the model again from the program that made it.`;
  return new LissomError('file-damaged', message);
}
