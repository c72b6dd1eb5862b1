// What there is to go back to: the documents of the store, and what the journal has beyond it.

import { LissomError } from '../core/errors';
import { parseRecipe } from '../recipe/parse';
import type { Recipe } from '../recipe/recipe';
import type { MessageService } from './api';
import type { Entry } from './document';
import { t } from './i18n';
import type { Journal, JournalEntry } from './journal';
import type { ModelStore, OpenedFile } from './model-store';
import { type KeptDocument, replayed } from './replay';
import { type DocumentStore, type StoredDocument, selectionOf } from './store';
import type { Claims } from './tab-claim';

export interface KeptWorkParts {
  readonly store: DocumentStore;
  readonly journal: Journal;
  readonly models: ModelStore;
  readonly claims: Claims;
  readonly messages: MessageService;
  readonly newId: () => string;
  /** Called when a document that cannot be reached goes on as a copy. */
  readonly onCopied: (id: string, copy: string) => void;
}

/** A file that a document names, as the store knows it. */
export type KeptFile = Pick<OpenedFile, 'file' | 'hash'>;

/** What could be read of a stored document. */
export interface Opened {
  readonly entries: readonly Entry[];
  readonly index: number;
  /** Files that the browser no longer has, or does not give now. */
  readonly missing: readonly KeptFile[];
  /** Whether that is because its store does not answer. */
  readonly isSilent: boolean;
  /** How many states of the history it no longer has. */
  readonly lost: number;
}

export class KeptWork {
  /** Replayed from the journal, but not yet taken by the store. */
  readonly #replayed = new Map<string, KeptDocument>();
  /** The store did not answer when it was asked last. */
  #isSilent = false;

  constructor(private readonly parts: KeptWorkParts) {}

  /** Every one there is, newest first. @param open  the one that is open in this tab: its journal is being written */
  async documents(open: string): Promise<readonly StoredDocument[]> {
    const { journal, store, messages } = this.parts;
    let stored: readonly StoredDocument[] = [];
    try {
      const left = journal.ids();
      stored = await store.documents();
      this.#isSilent = false;
      await this.#eachLeft(open, (entry) => this.#takeUp(entry));
      // What was left is in the store by now, by this tab's doing or another's.
      if (left.length > 0) stored = await store.documents();
    } catch (error) {
      messages.failed(error);
      this.#isSilent = true;
    }
    if (this.#isSilent) await this.#eachLeft(open, (entry) => this.#takeUpUnseen(entry).then(() => {}));
    const all = new Map(stored.map((each) => [each.id, each]));
    for (const [id, { document }] of this.#replayed) all.set(id, document);
    return [...all.values()].sort((a, b) => b.time - a.time);
  }

  /**
   * What tabs that are gone have left in the journal. Nothing is claimed: one of them may just be coming back, and its
   * document must be free for it. What it does meanwhile is newer, and never written over.
   */
  async #eachLeft(open: string, takeUp: (entry: JournalEntry) => Promise<void>): Promise<void> {
    const { claims, journal, messages } = this.parts;
    for (const id of journal.ids()) {
      if (id === open || !(await claims.isFree(id))) continue;
      try {
        const entry = journal.read(id);
        if (entry) await takeUp(entry);
      } catch (error) {
        messages.failed(error);
      }
    }
  }

  async #takeUp(entry: JournalEntry): Promise<void> {
    const { journal, store } = this.parts;
    const known = await store.document(entry.id);
    if (known && (known.revision ?? 0) >= entry.revision) {
      journal.remove(entry.id, entry.revision);
      return;
    }
    const kept = await replayed(entry, known);
    try {
      await store.write(kept.document, kept.blobs, true);
    } catch {
      this.#replayed.set(entry.id, kept); // it stays in the journal; the next save says what is wrong
      return;
    }
    journal.remove(entry.id, entry.revision);
    this.#replayed.delete(entry.id);
  }

  /**
   * The store may have a history of the document, which one without it must not replace later: a copy.
   * @returns its name
   */
  async #takeUpUnseen(entry: JournalEntry): Promise<string> {
    if (this.#replayed.has(entry.id)) return entry.id;
    const moved = this.parts.journal.move(entry, this.parts.newId());
    this.parts.onCopied(entry.id, moved.id);
    this.#replayed.set(moved.id, await replayed(moved));
    return moved.id;
  }

  /**
   * The newest there is of a document that this tab has claimed. While its last page was still going, what that had
   * left in the journal was not there to be taken up.
   */
  async newest(stored: StoredDocument): Promise<StoredDocument> {
    const entry = this.parts.journal.read(stored.id);
    if (!entry || entry.revision <= (stored.revision ?? 0)) return stored;
    let { id } = entry;
    try {
      await this.#takeUp(entry);
    } catch (error) {
      this.parts.messages.failed(error);
      this.#isSilent = true;
      id = await this.#takeUpUnseen(entry);
    }
    return (await this.document(id)) ?? stored;
  }

  async document(id: string): Promise<StoredDocument | undefined> {
    return this.#replayed.get(id)?.document ?? this.parts.store.document(id);
  }

  /** Whether the store still lacks what was replayed. */
  isUnwritten(id: string): boolean {
    return this.#replayed.has(id);
  }

  /** The store has all of it now. */
  written(id: string): void {
    this.#replayed.delete(id);
    this.#isSilent = false;
  }

  /** Puts back those of the files that the store has by now. @returns the others */
  async putBack(files: readonly KeptFile[]): Promise<readonly KeptFile[]> {
    const missing: KeptFile[] = [];
    for (const { file, hash } of files) {
      // A file that cannot be read now is no reason to go without the work.
      const bytes = await this.#blob(hash).catch(() => undefined);
      if (bytes) this.parts.models.put({ file, hash, bytes });
      else missing.push({ file, hash });
    }
    return missing;
  }

  /** Puts the files back and reads the history. @throws LissomError  where nothing is left of it */
  async read({ id, title, entries: stored, index, files }: StoredDocument): Promise<Opened> {
    const { store } = this.parts;
    const missing = await this.putBack(files);
    const recipes = new Map<string, Recipe | undefined>();
    const entries: Entry[] = [];
    let shown = 0;
    for (const [i, { recipe: hash, selection, label, time }] of stored.entries()) {
      if (!recipes.has(hash)) {
        const bytes = await this.#blob(hash);
        recipes.set(hash, bytes && parseRecipe(new TextDecoder().decode(bytes)));
      }
      const document = recipes.get(hash);
      if (!document) continue;
      if (i <= index) shown = entries.length;
      entries.push({ document, selection: selectionOf(selection), label, time });
    }
    if (entries.length === 0) {
      await store.remove([id]);
      throw new LissomError('work-gone', t('error.work-gone', { title }));
    }
    return { entries, index: shown, missing, isSilent: this.#isSilent, lost: stored.length - entries.length };
  }

  async #blob(hash: string): Promise<Uint8Array | undefined> {
    for (const { blobs } of this.#replayed.values()) if (blobs.has(hash)) return blobs.get(hash);
    return this.#isSilent ? undefined : this.parts.store.blob(hash);
  }
}
