import { Hasher } from '../../core/hash';
import { ByteWriter } from '../byte-writer';

// Ogawa, the container of Alembic files: groups of references and blocks of data, anywhere in the file, found from a
// root group whose place stands at the head. Children are written before the group that names them.

/** Where a group or block begins; an empty one has no place. */
export interface Ref {
  readonly at: number;
  readonly kind: 'group' | 'data';
}

export const EMPTY_GROUP: Ref = { at: 0, kind: 'group' };
export const EMPTY_DATA: Ref = { at: 0, kind: 'data' };

/** Bytes 8–15: the root group's place. */
const ROOT_PLACE = 8;
/** Top bit of a reference: data. */
const DATA = 0x80000000;

export class OgawaWriter {
  readonly #out: ByteWriter;

  constructor(expected: number) {
    this.#out = new ByteWriter(expected);
    this.#out.text('Ogawa');
    // Complete (not being written to), format version 1.
    this.#out.raw(Uint8Array.of(0xff, 0, 1));
    this.#u64(0);
  }

  data(...parts: readonly Uint8Array[]): Ref {
    const at = this.#out.length;
    this.#u64(parts.reduce((sum, part) => sum + part.length, 0));
    for (const part of parts) this.#out.raw(part);
    return { at, kind: 'data' };
  }

  group(children: readonly Ref[]): Ref {
    if (children.length === 0) return EMPTY_GROUP;
    const at = this.#out.length;
    this.#u64(children.length);
    for (const child of children) this.#u64(child.at, child.kind === 'data');
    return { at, kind: 'group' };
  }

  finish(root: Ref): Uint8Array {
    const bytes = this.#out.finish();
    const view = new DataView(bytes.buffer);
    view.setUint32(ROOT_PLACE, root.at >>> 0, true);
    view.setUint32(ROOT_PLACE + 4, Math.floor(root.at / 2 ** 32), true);
    return bytes;
  }

  #u64(value: number, isData = false): void {
    this.#out.u32(value >>> 0);
    this.#out.u32((Math.floor(value / 2 ** 32) | (isData ? DATA : 0)) >>> 0);
  }
}

/** 16 bytes that tell one content from another. */
export function contentKey(...parts: readonly ArrayBufferView[]): Uint8Array {
  const hasher = new Hasher();
  for (const part of parts) hasher.bytes(part);
  const digest = hasher.digest();
  return Uint8Array.from({ length: 16 }, (_, i) => Number.parseInt(digest.slice(2 * i, 2 * i + 2), 16));
}
