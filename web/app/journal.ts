// The newest state of each document in localStorage, which is written before the call returns: what an edit
// made is there even where the tab goes at once, long before the database has it. One small entry a document,
// without files; removed as soon as the database is as new.

import { inline } from '../recipe/format';
import type { Recipe } from '../recipe/recipe';
import { recipeText } from './recipe-text';
import type { StoredDocument, StoredEntry } from './store';

type State = Pick<StoredEntry, 'selection' | 'label' | 'time'>;

interface Header extends State, Pick<StoredDocument, 'id' | 'title' | 'link' | 'files'> {
  readonly revision: number;
  /** The state before it in the history: what the stored history is cut off after. */
  readonly after?: Pick<StoredEntry, 'label' | 'time'>;
}

export interface NewState extends Header {
  readonly recipe: Recipe;
}

export interface JournalEntry extends Header {
  /** As written: by this version or an older one. */
  readonly recipe: unknown;
}

export type JournalStorage = Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'>;

const PREFIX = 'lissom.journal.';
/** Characters of one entry. Browsers give a site some five million in all, and several tabs share them. */
const LONGEST = 1_000_000;

export class Journal {
  /** @param storage  `null` where the browser forbids it */
  constructor(private readonly storage: JournalStorage | null) {}

  /** @returns false where it has no room: the database must have it at once */
  write({ recipe, ...header }: NewState): boolean {
    const text = `${JSON.stringify(header).slice(0, -1)},"recipe":${recipeText(recipe)}}`;
    if (text.length > LONGEST) return false;
    return this.#put(header.id, text);
  }

  /** The documents that have an entry. */
  ids(): readonly string[] {
    const { storage } = this;
    if (!storage) return [];
    const keys = Array.from({ length: storage.length }, (_, i) => storage.key(i) ?? '');
    return keys.filter((key) => key.startsWith(PREFIX)).map((key) => key.slice(PREFIX.length));
  }

  /** What is no entry, whatever its name says, is removed. */
  read(id: string): JournalEntry | undefined {
    try {
      const entry = JSON.parse(this.storage?.getItem(PREFIX + id) ?? '') as JournalEntry;
      if (entry.id === id) return entry;
    } catch {
      // Not written by this program.
    }
    this.remove(id);
    return undefined;
  }

  /** @param revision  the entry is left in place where it is newer than this by now */
  remove(id: string, revision = Number.POSITIVE_INFINITY): void {
    if (Number.isFinite(revision) && (this.read(id)?.revision ?? 0) > revision) return;
    this.storage?.removeItem(PREFIX + id);
  }

  /** Goes on under another document's name. */
  move(entry: JournalEntry, id: string): JournalEntry {
    const moved = { ...entry, id };
    this.remove(entry.id);
    this.#put(id, inline(moved));
    return moved;
  }

  #put(id: string, text: string): boolean {
    try {
      this.storage?.setItem(PREFIX + id, text);
      return this.storage !== null;
    } catch {
      return false; // full, or forbidden since
    }
  }
}
