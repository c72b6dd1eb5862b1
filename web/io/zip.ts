import { Inflate } from 'fflate';
import { crc32 } from '../core/crc32';
import { LissomError } from '../core/errors';
import { inBytes } from '../core/sizes';

/** Bytes of all unpacked files together, and their number, beyond which an archive is refused. */
export interface ZipLimits {
  readonly bytes: number;
  readonly files: number;
  /** For one file of the archive, where it has a limit of its own. */
  readonly bytesOf?: (name: string) => number | undefined;
}

interface ZipEntry {
  readonly name: string;
  readonly method: number;
  readonly checksum: number;
  readonly packed: number;
  readonly unpacked: number;
  /** Where its local header begins. */
  readonly header: number;
}

// Signatures and layouts: PKWARE APPNOTE.TXT 6.3, sections 4.3.7, 4.3.12 and 4.3.16.
const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const END_SIZE = 22;
/** Of a local header without its name. */
const LOCAL_SIZE = 30;
const LONGEST_COMMENT = 65535;
const STORED = 0;
const DEFLATED = 8;
/** Deflate makes at most about 1000 bytes of one: a slice this small cannot overrun the memory. */
const SLICE = 16384;

/**
 * The files of a zip archive by name, folders left out. Declared sizes are limited before anything is unpacked, and
 * what comes out may not exceed its declaration, which may lie.
 *
 * @throws LissomError `zip-damaged`, `zip-too-large`, `zip-unsafe-name`, `file-empty`
 */
export function readZip(bytes: Uint8Array, limits: ZipLimits): Map<string, Uint8Array> {
  if (bytes.length === 0) throw new LissomError('file-empty', 'The archive is empty: 0 bytes.');
  const entries = readDirectory(bytes, limits).filter(({ name }) => !name.endsWith('/'));
  const declared = entries.reduce((sum, { unpacked }) => sum + unpacked, 0);
  if (declared > limits.bytes) throw tooLarge(limits);
  refuseLarge(entries, limits);
  refuseShared(entries);
  const files = new Map<string, Uint8Array>();
  for (const entry of entries) {
    checkName(entry.name);
    if (files.has(entry.name)) throw damaged(`it holds “${entry.name}” twice`);
    files.set(entry.name, unpack(bytes, entry));
  }
  return files;
}

function refuseLarge(entries: readonly ZipEntry[], { bytesOf }: ZipLimits): void {
  for (const { name, unpacked } of entries) {
    const most = bytesOf?.(name);
    if (most === undefined || unpacked <= most) continue;
    const message =
      `“${name}” in the archive has ${inBytes(unpacked)}; the limit is ${inBytes(most)}. ` +
      'Nothing that is made here is that large: fetch the archive again from where it was made.';
    throw new LissomError('zip-too-large', message);
  }
}

/** Files that share their bytes unpack to far more than an archive holds: none that is packed by a program has any. */
function refuseShared(entries: readonly ZipEntry[]): void {
  const sorted = entries.toSorted((a, b) => a.header - b.header);
  for (const [at, { name, header, packed }] of sorted.entries()) {
    const next = sorted[at + 1];
    if (next && header + LOCAL_SIZE + packed > next.header)
      throw damaged(`“${name}” and “${next.name}” share their bytes`);
  }
}

/** @throws LissomError `zip-unsafe-name` for a name that could lead out of the folder it is unpacked to */
export function checkName(name: string): void {
  const parts = name.split('/');
  const plain =
    !/[\\:\p{Cc}]/u.test(name) && parts.every((part) => part !== '' && part !== '.' && part !== '..');
  if (plain) return;
  const message = `The archive holds a file called “${name}”, which points out of it. It was not opened.`;
  throw new LissomError('zip-unsafe-name', message);
}

function readDirectory(bytes: Uint8Array, limits: ZipLimits): ZipEntry[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const end = findEnd(view);
  const count = view.getUint16(end + 10, true);
  if (count > limits.files) throw tooLarge(limits);
  const entries: ZipEntry[] = [];
  let at = view.getUint32(end + 16, true);
  for (let i = 0; i < count; i++) {
    if (at + 46 > end || view.getUint32(at, true) !== CENTRAL)
      throw damaged('its table of contents is broken');
    if (view.getUint16(at + 8, true) & 1) throw damaged('it is locked with a password');
    const nameLength = view.getUint16(at + 28, true);
    const next = at + 46 + nameLength + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    entries.push({
      name: new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + nameLength)),
      method: view.getUint16(at + 10, true),
      checksum: view.getUint32(at + 16, true),
      packed: view.getUint32(at + 20, true),
      unpacked: view.getUint32(at + 24, true),
      header: view.getUint32(at + 42, true),
    });
    at = next;
  }
  return entries;
}

function findEnd(view: DataView): number {
  const first = Math.max(0, view.byteLength - END_SIZE - LONGEST_COMMENT);
  for (let at = view.byteLength - END_SIZE; at >= first; at--)
    if (view.getUint32(at, true) === END) return at;
  throw damaged('its end is missing, so it is no zip archive or was cut short');
}

function unpack(bytes: Uint8Array, entry: ZipEntry): Uint8Array {
  const { name, method, packed, unpacked, header } = entry;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (header + LOCAL_SIZE > bytes.length || view.getUint32(header, true) !== LOCAL)
    throw damaged(`“${name}” is missing`);
  const start = header + LOCAL_SIZE + view.getUint16(header + 26, true) + view.getUint16(header + 28, true);
  if (start + packed > bytes.length) throw damaged(`“${name}” is cut short`);
  const content = bytes.subarray(start, start + packed);
  // A larger ratio than deflate can reach is a lie, and would set memory aside for nothing.
  if (unpacked > 1100 * (packed + 1)) throw damaged(`the size of “${name}” cannot be true`);
  let out: Uint8Array;
  if (method === STORED) out = content.slice();
  else if (method === DEFLATED) out = inflate(content, name, unpacked);
  else throw damaged(`“${name}” is packed in an unusual way`);
  if (out.length !== unpacked || crc32(out) !== entry.checksum)
    throw damaged(`the content of “${name}” is broken`);
  return out;
}

function inflate(content: Uint8Array, name: string, size: number): Uint8Array {
  const out = new Uint8Array(size);
  let length = 0;
  const stream = new Inflate((chunk) => {
    if (length + chunk.length > size) throw damaged(`“${name}” is larger than declared`);
    out.set(chunk, length);
    length += chunk.length;
  });
  try {
    for (let at = 0; at < content.length; at += SLICE)
      stream.push(content.subarray(at, at + SLICE), at + SLICE >= content.length);
  } catch (error) {
    if (error instanceof LissomError) throw error;
    throw damaged(`the content of “${name}” is broken`);
  }
  return out.subarray(0, length);
}

function damaged(what: string): LissomError {
  const message = `The archive cannot be opened: ${what}. Fetch or save it again.`;
  return new LissomError('zip-damaged', message);
}

function tooLarge({ bytes, files }: ZipLimits): LissomError {
  const message =
    `The archive unpacks to more than ${inBytes(bytes)} or ${files} files, which is refused. ` +
    'Unpack it yourself and open the models one by one.';
  return new LissomError('zip-too-large', message);
}
