// Where the app's models come from: the gallery by name, opened files by name and content.

import { LissomError } from '../core/errors';
import { Hasher } from '../core/hash';
import type { Model } from '../core/model';
import { readModel } from '../io/formats';
import type { ReadResult } from '../io/reading';
import type { ModelRef } from '../recipe/recipe';
import type { ModelSource } from '../run/types';
import { t } from './i18n';

export interface OpenedFile {
  /** As recipes name it: the file's own name, with a number where another content has it already. */
  readonly file: string;
  readonly bytes: Uint8Array;
  /** SHA-256 of the bytes, hexadecimal: what restore points keep it under. */
  readonly hash: string;
}

type OpenedMesh = ReadResult & Pick<OpenedFile, 'file'>;

export class ModelStore implements ModelSource {
  readonly #files = new Map<string, OpenedFile>();
  readonly #read = new Map<string, Promise<ReadResult>>();

  /** @param builtin  a model of the gallery */
  constructor(private readonly builtin: (name: string) => Promise<ReadResult>) {}

  /** Keeps a file for recipes to refer to. The same content twice is one file; another takes a new name. */
  async add(name: string, bytes: Uint8Array): Promise<OpenedFile> {
    const hash = await sha256(bytes);
    for (let n = 1; ; n++) {
      const file = n === 1 ? name : name.replace(/(\.[^.]*)?$/, ` ${n}$1`);
      const held = this.#files.get(file);
      if (held && held.hash !== hash) continue;
      const opened = held ?? { file, bytes, hash };
      this.#files.set(file, opened);
      return opened;
    }
  }

  /**
   * Keeps a mesh file together with what was read of it, so that nobody reads it again.
   *
   * @throws what its reader throws; nothing is kept then
   */
  async open(
    name: string,
    bytes: Uint8Array,
    read: ReadResult = readModel(bytes, name),
  ): Promise<OpenedMesh> {
    const { file } = await this.add(name, bytes);
    const key = `file:${file}`;
    const { model, notes } = read;
    if (!this.#read.has(key))
      this.#read.set(key, Promise.resolve(file === name ? read : { model: { ...model, name: file }, notes }));
    return { file, ...(await this.read({ file })) };
  }

  /** Puts a file back under the name a stored recipe has for it. */
  put(file: OpenedFile): void {
    if (this.#files.get(file.file)?.hash !== file.hash) this.#read.delete(`file:${file.file}`);
    this.#files.set(file.file, file);
  }

  get(file: string): OpenedFile | undefined {
    return this.#files.get(file);
  }

  /** The model with what its reader noticed. */
  read(ref: ModelRef): Promise<ReadResult> {
    const key = 'file' in ref ? `file:${ref.file}` : `builtin:${ref.builtin}`;
    let reading = this.#read.get(key);
    if (!reading) {
      reading = this.#parse(ref);
      this.#read.set(key, reading);
      // A failure is not an answer for ever: the connection may come back.
      reading.catch(() => this.#read.delete(key));
    }
    return reading;
  }

  async load(_name: string, ref: ModelRef): Promise<Model> {
    return (await this.read(ref)).model;
  }

  async #parse(ref: ModelRef): Promise<ReadResult> {
    if ('builtin' in ref) return this.builtin(ref.builtin);
    const held = this.#files.get(ref.file);
    if (!held) throw new LissomError('model-not-found', t('error.model-not-found', { name: ref.file }));
    return readModel(held.bytes, ref.file);
  }
}

/** Where the page is not a secure context the browser gives no SHA-256; the quick hash tells files apart too. */
export async function sha256(bytes: Uint8Array): Promise<string> {
  if (!globalThis.crypto?.subtle) return new Hasher().bytes(bytes).digest();
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes as Uint8Array<ArrayBuffer>));
  return [...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}
