// What autosave keeps in the browser: restore points, and by their hash the recipes and files they name.

import { type DBSchema, type IDBPDatabase, openDB } from 'idb';
import type { Selection } from './state';

/** One state in a restore point's history. */
export interface StoredEntry {
  /** Hash of the recipe's text. */
  readonly recipe: string;
  readonly selection: Selection;
  readonly label: string;
  readonly time: number;
}

export interface StoredDocument {
  readonly id: string;
  readonly time: number;
  readonly title: string;
  readonly kind: 'auto' | 'kept';
  readonly link?: string;
  readonly entries: readonly StoredEntry[];
  readonly index: number;
  readonly files: readonly { readonly file: string; readonly hash: string }[];
  readonly steps: number;
  readonly handles: number;
}

/** Tests keep it in memory. */
export interface DocumentStore {
  documents(): Promise<readonly StoredDocument[]>;
  document(id: string): Promise<StoredDocument | undefined>;
  blob(hash: string): Promise<Uint8Array | undefined>;
  /** Which of these are not kept yet. */
  missing(hashes: Iterable<string>): Promise<readonly string[]>;
  /** All or nothing. */
  write(document: StoredDocument, blobs: ReadonlyMap<string, Uint8Array>): Promise<void>;
  /** Removes documents, and blobs that none of the others names. */
  remove(ids: readonly string[]): Promise<void>;
}

interface Schema extends DBSchema {
  documents: { key: string; value: StoredDocument };
  blobs: { key: string; value: Uint8Array };
}

export const hashesOf = ({ entries, files }: StoredDocument): string[] => [
  ...entries.map(({ recipe }) => recipe),
  ...files.map(({ hash }) => hash),
];

export class BrowserStore implements DocumentStore {
  #database: Promise<IDBPDatabase<Schema>> | undefined;

  async documents(): Promise<readonly StoredDocument[]> {
    return (await this.#open()).getAll('documents');
  }

  async document(id: string): Promise<StoredDocument | undefined> {
    return (await this.#open()).get('documents', id);
  }

  async blob(hash: string): Promise<Uint8Array | undefined> {
    return (await this.#open()).get('blobs', hash);
  }

  async missing(hashes: Iterable<string>): Promise<readonly string[]> {
    const blobs = (await this.#open()).transaction('blobs').store;
    const wanted = [...new Set(hashes)];
    const keys = await Promise.all(wanted.map((hash) => blobs.getKey(hash)));
    return wanted.filter((_, i) => keys[i] === undefined);
  }

  async write(document: StoredDocument, blobs: ReadonlyMap<string, Uint8Array>): Promise<void> {
    const transaction = (await this.#open()).transaction(['documents', 'blobs'], 'readwrite');
    for (const [hash, bytes] of blobs) transaction.objectStore('blobs').put(bytes, hash);
    transaction.objectStore('documents').put(document);
    await transaction.done;
  }

  async remove(ids: readonly string[]): Promise<void> {
    const transaction = (await this.#open()).transaction(['documents', 'blobs'], 'readwrite');
    const documents = transaction.objectStore('documents');
    const blobs = transaction.objectStore('blobs');
    const all = await documents.getAll();
    const kept = new Set(all.filter(({ id }) => !ids.includes(id)).flatMap(hashesOf));
    for (const id of ids) documents.delete(id);
    for (const hash of await blobs.getAllKeys()) if (!kept.has(hash)) blobs.delete(hash);
    await transaction.done;
  }

  #open(): Promise<IDBPDatabase<Schema>> {
    this.#database ??= openDB<Schema>('lissom', 1, {
      upgrade(database) {
        database.createObjectStore('documents', { keyPath: 'id' });
        database.createObjectStore('blobs');
      },
      // Another tab with a newer version must not wait for this one.
      blocking: (_old, _new, event) => (event.target as IDBDatabase).close(),
      terminated: () => {
        this.#database = undefined;
      },
    });
    return this.#database;
  }
}
