// What autosave keeps in the browser: restore points, and by their hash the recipes and files they name.

import { type DBSchema, type IDBPDatabase, openDB } from 'idb';
import { t } from './i18n';
import type { Selection } from './state';

/** Documents of earlier versions say `handle` for any item. */
export type StoredSelection = Selection | { readonly step: string; readonly handle: number | null };

export const selectionOf = (stored: StoredSelection): Selection =>
  'item' in stored ? stored : { step: stored.step, item: stored.handle };

/** One state in a restore point's history. */
export interface StoredEntry {
  /** Hash of the recipe's text. */
  readonly recipe: string;
  readonly selection: StoredSelection;
  readonly label: string;
  readonly time: number;
}

export interface StoredDocument {
  readonly id: string;
  /** Counts the document's edits; 0 where it is missing. A journal entry with a higher one is newer. */
  readonly revision?: number;
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
  /**
   * Adds those of the blobs that are not kept yet, and the document. All or nothing.
   * @param onlyNewer  nothing where the document is kept already with as high a revision
   */
  write(document: StoredDocument, blobs: ReadonlyMap<string, Uint8Array>, onlyNewer?: boolean): Promise<void>;
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

/** A database that does not answer must not hold up the page, in milliseconds; large blobs take their time. */
const PATIENCE = 5_000;
const PATIENCE_FOR_BLOB = 60_000;
const SLOWEST_BYTES_PER_MILLISECOND = 2_000;

type Database = IDBPDatabase<Schema>;

export class BrowserStore implements DocumentStore {
  #database: Promise<Database> | undefined;

  documents(): Promise<readonly StoredDocument[]> {
    return this.#ask((database) => database.getAll('documents'));
  }

  document(id: string): Promise<StoredDocument | undefined> {
    return this.#ask((database) => database.get('documents', id));
  }

  blob(hash: string): Promise<Uint8Array | undefined> {
    return this.#ask((database) => database.get('blobs', hash), PATIENCE_FOR_BLOB);
  }

  write(document: StoredDocument, blobs: ReadonlyMap<string, Uint8Array>, onlyNewer = false): Promise<void> {
    const bytes = [...blobs.values()].reduce((sum, { byteLength }) => sum + byteLength, 0);
    return this.#ask(
      async (database) => {
        // Looked for and written in one transaction: in between, another tab could remove what was found.
        const transaction = database.transaction(['documents', 'blobs'], 'readwrite');
        const kept = transaction.objectStore('blobs');
        if (onlyNewer) {
          const known = await transaction.objectStore('documents').get(document.id);
          if (known && (known.revision ?? 0) >= (document.revision ?? 0)) return;
        }
        await wholly(transaction, [
          ...[...blobs].map(([hash, bytes]) => async () => {
            if ((await kept.getKey(hash)) === undefined) await kept.put(bytes, hash);
          }),
          () => transaction.objectStore('documents').put(document),
        ]);
      },
      PATIENCE + bytes / SLOWEST_BYTES_PER_MILLISECOND,
    );
  }

  remove(ids: readonly string[]): Promise<void> {
    return this.#ask(async (database) => {
      const transaction = database.transaction(['documents', 'blobs'], 'readwrite');
      const documents = transaction.objectStore('documents');
      const blobs = transaction.objectStore('blobs');
      const all = await documents.getAll();
      const kept = new Set(all.filter(({ id }) => !ids.includes(id)).flatMap(hashesOf));
      const gone = (await blobs.getAllKeys()).filter((hash) => !kept.has(hash));
      await wholly(transaction, [
        ...ids.map((id) => () => documents.delete(id)),
        ...gone.map((hash) => () => blobs.delete(hash)),
      ]);
    });
  }

  /** Asks once more with a database opened anew where the open one turns out to be closed. */
  async #ask<T>(work: (database: Database) => Promise<T>, patience = PATIENCE): Promise<T> {
    const answered = async () => {
      const opened = this.#open();
      const database = await within(PATIENCE, opened);
      try {
        return await work(database);
      } catch (error) {
        if (!isClosed(error)) throw error;
        this.#forget(opened);
        return work(await this.#open());
      }
    };
    return within(patience, answered());
  }

  #open(): Promise<Database> {
    if (this.#database) return this.#database;
    const opened = openDB<Schema>('lissom', 1, {
      upgrade(database) {
        database.createObjectStore('documents', { keyPath: 'id' });
        database.createObjectStore('blobs');
      },
      // Another tab with a newer version must not wait for this one.
      blocking: (_old, _new, event) => {
        (event.target as IDBDatabase).close();
        this.#forget(opened);
      },
      terminated: () => this.#forget(opened),
    });
    this.#database = opened;
    opened.catch(() => this.#forget(opened));
    return opened;
  }

  /** The next question opens it again. */
  #forget(opened: Promise<Database>): void {
    if (this.#database === opened) this.#database = undefined;
  }
}

/**
 * All of a transaction or nothing. A request that fails ends it by itself; one that is refused before it is made does
 * not, and what the others have written would be kept without its part.
 */
async function wholly(
  transaction: { readonly done: Promise<void>; abort(): void },
  parts: readonly (() => Promise<unknown>)[],
): Promise<void> {
  const made = parts.map(async (make) => make());
  try {
    await Promise.all(made);
  } catch (error) {
    // Nobody waits for the rest any more.
    for (const each of [...made, transaction.done]) each.catch(() => {});
    abort(transaction);
    throw error;
  }
  await transaction.done;
}

function abort(transaction: { abort(): void }): void {
  try {
    transaction.abort();
  } catch {
    // It had ended already.
  }
}

const isClosed = (error: unknown): boolean =>
  error instanceof DOMException && error.name === 'InvalidStateError';

/** @throws once the patience is over; an answer that comes later is not waited for */
function within<T>(patience: number, answer: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const late = setTimeout(() => reject(new Error(t('error.store-silent'))), patience);
    answer.then(resolve, reject).finally(() => clearTimeout(late));
  });
}
