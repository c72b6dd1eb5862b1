import * as v from 'valibot';
import { LissomError } from '../core/errors';
import { type GltfJson, gltfSchema } from './gltf-schema';
import { nestsDeeper } from './json-depth';
import { truncated } from './reading';
import { decode } from './text-scanner';

/** The parsed document and its binary parts; a buffer that is not in the file is missing. */
export interface GltfDocument {
  readonly file: string;
  readonly json: GltfJson;
  readonly buffers: readonly (Uint8Array | undefined)[];
  /** Of the file it came from, in bytes. */
  readonly size: number;
}

const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
/** Lists and objects in one another: glTF's own lie nine deep, what programs add to it seldom deeper. */
const DEEPEST = 200;

/** @throws LissomError `file-truncated`, `file-damaged`, `format-unsupported` */
export function openGlb(bytes: Uint8Array, file: string): GltfDocument {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 20) throw truncated(file, 20, bytes.length);
  const version = view.getUint32(4, true);
  if (version !== 2) {
    const message = `${file} is glTF version ${version}; only version 2 can be read. Export it again as glTF 2.0.`;
    throw new LissomError('format-unsupported', message);
  }
  const length = view.getUint32(8, true);
  if (length > bytes.length) throw truncated(file, length, bytes.length);
  let json: Uint8Array | undefined;
  let binary: Uint8Array | undefined;
  for (let at = 12; at + 8 <= length; ) {
    const size = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    const end = at + 8 + size;
    if (end > bytes.length) throw truncated(file, end, bytes.length);
    if (type === JSON_CHUNK) json ??= bytes.subarray(at + 8, end);
    else if (type === BIN_CHUNK) binary ??= bytes.subarray(at + 8, end);
    at = end;
  }
  if (!json) throw gltfDamaged(file, 'it has no JSON part');
  return openJson(json, file, bytes.length, binary);
}

/** @throws LissomError `file-damaged`, `format-unsupported` */
export function openGltf(bytes: Uint8Array, file: string): GltfDocument {
  return openJson(bytes, file, bytes.length, undefined);
}

export function gltfDamaged(file: string, what: string): LissomError {
  const message = `${file} is not valid glTF: ${what}. Export it again from the program that made it.`;
  return new LissomError('file-damaged', message);
}

/** `list[index]`, which a valid file has. */
export function entry<T>(doc: GltfDocument, list: readonly T[] | undefined, index: number, what: string): T {
  const found = list?.[index];
  if (found === undefined || found === null)
    throw gltfDamaged(doc.file, `it refers to ${what} ${index}, which is missing`);
  return found;
}

function openJson(
  bytes: Uint8Array,
  file: string,
  size: number,
  binary: Uint8Array | undefined,
): GltfDocument {
  if (nestsDeeper(bytes, DEEPEST))
    throw gltfDamaged(file, `its JSON part is nested more than ${DEEPEST} deep`);
  let json: GltfJson;
  try {
    json = JSON.parse(decode(bytes)) as GltfJson;
  } catch (error) {
    throw gltfDamaged(file, `its JSON part cannot be read (${(error as Error).message})`);
  }
  if (!String(json?.asset?.version).startsWith('2.'))
    throw new LissomError(
      'format-unsupported',
      `${file} is not glTF version 2, the only one that can be read. Export it again as glTF 2.0.`,
    );
  const { issues } = v.safeParse(gltfSchema, json);
  if (issues) throw gltfDamaged(file, `“${v.getDotPath(issues[0]) ?? 'asset'}” is not what glTF has there`);
  // Views compressed with meshopt may have no other content even where the file does not insist on unpacking.
  const meshopt = (json.extensionsUsed ?? []).filter((e) => /meshopt_compression/i.test(e));
  refuseCompressed([...(json.extensionsRequired ?? []), ...meshopt], file);
  const buffers = (json.buffers ?? []).map(({ uri }, i) => {
    if (uri === undefined) return i === 0 ? binary : undefined;
    return uri.startsWith('data:') ? fromDataUri(uri, file) : undefined;
  });
  return { file, json, buffers, size };
}

/** Compressed geometry cannot be unpacked here; the sentence says which, and what to do. */
export function refuseCompressed(extensions: readonly string[], file: string): void {
  const name = extensions.find((e) => /draco|meshopt_compression/i.test(e));
  if (!name) return;
  const kind = /draco/i.test(name) ? 'Draco' : 'meshopt';
  const message = `${file} is compressed with ${kind}, which cannot be unpacked here. Export it again without compression.`;
  throw new LissomError('format-unsupported', message);
}

function fromDataUri(uri: string, file: string): Uint8Array {
  const comma = uri.indexOf(',');
  try {
    if (!uri.slice(0, comma).endsWith(';base64'))
      return new TextEncoder().encode(decodeURIComponent(uri.slice(comma + 1)));
    const text = atob(uri.slice(comma + 1));
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
    return bytes;
  } catch {
    throw gltfDamaged(file, 'a buffer written into the file cannot be decoded');
  }
}
