// Keeps the work in the browser: the newest state in the journal at every edit, all of it with its undo history
// in the store within two seconds. Brings it back after a reload or a crash. Every document that is opened gets
// a restore point of its own; the last 20 are kept.

import type { Recipe } from '../recipe/recipe';
import type { AutosaveService, MessageService, RestorePoint } from './api';
import type { Document } from './document';
import { t } from './i18n';
import { Journal, type JournalStorage } from './journal';
import { type KeptFile, KeptWork, type Opened } from './kept-work';
import type { ModelStore } from './model-store';
import { hashedText } from './recipe-text';
import { countsOf } from './replay';
import type { State } from './state';
import type { DocumentStore, StoredDocument } from './store';
import type { Claims } from './tab-claim';

export const MOST_RESTORE_POINTS = 20;
/** Undo steps that survive a reload. */
const MOST_ENTRIES = 200;
/** After an edit the store is written when nothing more comes for so long, in milliseconds … */
const DELAY = 1000;
/** … and at the latest so long after the first edit that it lacks. */
export const LONGEST_DELAY = 2000;
/** What could not be written is tried again after so long. */
const RETRY = 5000;
/** A page that was reloaded gives its document back within so long, on a machine that is busy. */
const PATIENCE = 3000;

export interface AutosaveParts {
  readonly state: State;
  readonly document: Document;
  readonly models: ModelStore;
  readonly store: DocumentStore;
  /** What the journal is written into; `null` where the browser forbids it. */
  readonly storage: JournalStorage | null;
  readonly claims: Claims;
  readonly messages: MessageService;
  /** Of this tab, lasting over reloads. */
  readonly tab: Pick<Storage, 'getItem' | 'setItem'>;
  /** The address leads to what is open: with another one a reload would bring something else. */
  readonly settleAddress: (link: string | undefined) => void;
  /** Whether this tab was open before: its last page may still be going. */
  readonly isReload: boolean;
  /** Asks the browser not to evict what is kept. */
  readonly persist: () => void;
  readonly newId: () => string;
  readonly now: () => number;
}

const TAB_KEY = 'lissom.document';

export class Autosave implements AutosaveService {
  #id = '';
  #own = false;
  #link: string | undefined;
  /** Files of this document that the store did not give: it may later. */
  #missing: readonly KeptFile[] = [];
  /** Edits of this document so far, and how many of them the store and the journal have. */
  #revision = 0;
  #written = 0;
  #journalled = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Runs from the first edit that the store lacks; later ones do not restart it. */
  #deadline: ReturnType<typeof setTimeout> | undefined;
  #writing: Promise<void> = Promise.resolve();
  #failing = false;
  #asked = false;
  readonly #journal: Journal;
  readonly #unsubscribe: () => void;
  /** Files that the store is known to have, by hash. */
  readonly #files = new Set<string>();
  readonly #kept: KeptWork;

  constructor(private readonly parts: AutosaveParts) {
    this.#journal = new Journal(parts.storage);
    const onCopied = (id: string, copy: string) => {
      if (parts.tab.getItem(TAB_KEY) === id) this.#rememberInTab(copy);
    };
    this.#kept = new KeptWork({ ...parts, journal: this.#journal, onCopied });
    this.#unsubscribe = parts.document.onCommit(() => {
      if (this.#isOwn) this.touch();
    });
    parts.claims.onLost((id) => {
      if (id === this.#id) this.#goOnAsCopy();
    });
  }

  /** Grows with every edit; over reloads too. */
  get revision(): number {
    return this.#revision;
  }

  /** Whether an edit is neither in the journal nor in the store: it would go with the page. */
  get isAtRisk(): boolean {
    if (this.#id === '' || !this.#isOwn) return false;
    return Math.max(this.#journalled, this.#written) < this.#revision;
  }

  /** A new document: what was kept of the last one stays. */
  begin({ own, link }: { readonly own: boolean; readonly link?: string | undefined }): void {
    this.#follow(this.parts.newId(), 0);
    void this.parts.claims.claim(this.#id);
    this.#own = own;
    this.#missing = [];
    this.#link = link;
    this.settleAddress();
    this.parts.state.saved.value = { kind: 'clean' };
  }

  /** Takes a link off the address that is not the open document's. */
  settleAddress(): void {
    this.parts.settleAddress(this.#link);
  }

  /** Marks the document as to be saved. */
  touch(): void {
    if (this.#id === '') return;
    this.#revision++;
    this.parts.state.saved.value = { kind: 'unsaved' };
    this.lastWord();
    // The journal has no files, and nothing that is too large for it.
    const now =
      this.#journalled < this.#revision || this.#filesOf(this.parts.document.recipe).some(this.#isNew);
    this.#schedule(now ? 0 : DELAY);
    if (this.#asked) return;
    this.#asked = true;
    this.parts.persist();
  }

  /** Puts the newest state into the journal if neither it nor the store has it. Done when it returns. */
  lastWord(): void {
    if (!this.isAtRisk) return;
    const { document, state } = this.parts;
    const current = document.entries[document.index]!;
    const after = document.entries[document.index - 1];
    const isWritten = this.#journal.write({
      id: this.#id,
      revision: this.#revision,
      title: state.title.peek(),
      ...(this.#link !== undefined && { link: this.#link }),
      selection: current.selection,
      label: current.label,
      time: current.time,
      ...(after && { after: { label: after.label, time: after.time } }),
      files: this.#named(current.document),
      recipe: current.document,
    });
    if (isWritten) this.#journalled = this.#revision;
  }

  /** Writes now what waits to be written. Never throws: what went wrong is in `state.saved`. */
  flush(kind: StoredDocument['kind'] = 'auto'): Promise<void> {
    this.#unschedule();
    if (this.#id === '' || !this.#isOwn || (kind === 'auto' && this.#isWritten)) return this.#writing;
    const id = this.#id;
    this.parts.state.saved.value = { kind: 'saving' };
    this.#writing = this.#writing.then(() => this.#save(id, kind));
    return this.#writing;
  }

  dispose(): void {
    this.#unschedule();
    this.#unsubscribe();
    this.#id = '';
  }

  /** Before another document takes its place. @returns whether there was work of one's own to keep */
  async setAside(): Promise<boolean> {
    const isOwn = this.#id !== '' && this.#isOwn;
    if (isOwn) await this.flush('kept');
    this.#unschedule();
    this.parts.claims.release(this.#id);
    this.#id = '';
    return isOwn;
  }

  async restorePoints(): Promise<readonly RestorePoint[]> {
    await this.flush();
    return (await this.#kept.documents(this.#id)).map(({ id, time, title, steps, handles, kind }) => {
      return { id, time, title, steps, handles, kind, current: id === this.#id };
    });
  }

  async restore(id: string): Promise<void> {
    if (id === this.#id) return;
    const known = await this.#kept.document(id);
    if (!known) return;
    const isMine = await this.parts.claims.claim(id);
    const work = isMine
      ? await this.#claimed(known)
      : { stored: known, opened: await this.#kept.read(known) };
    if (await this.setAside()) this.parts.messages.toast('info', t('toast.kept'));
    await this.#lay(work.stored, work.opened);
  }

  /**
   * What this tab had before it was reloaded, or what a closed one left behind.
   * @param link  the address opened now: its own stored changes go before it, no others do
   */
  async restoreLast(link?: string): Promise<boolean> {
    const all = await this.#kept.documents(this.#id);
    const mine = all.find(({ id }) => id === this.parts.tab.getItem(TAB_KEY));
    const candidates = link
      ? all.filter((each) => each === mine && each.link === link)
      : [mine, ...all.filter((each) => each.kind === 'auto')].filter((each) => each !== undefined);
    for (const candidate of candidates) {
      const patience = candidate === mine && this.parts.isReload ? PATIENCE : 0;
      if (!(await this.parts.claims.claim(candidate.id, patience))) continue;
      try {
        const { stored, opened } = await this.#claimed(candidate);
        await this.#lay(stored, opened);
        return true;
      } catch (error) {
        this.parts.claims.release(candidate.id);
        this.parts.messages.failed(error);
      }
    }
    return false;
  }

  /** Work of one's own: a file of one's own, or an edit of whatever was opened. */
  get #isOwn(): boolean {
    const { entries } = this.parts.document;
    return this.#own || entries.some(({ document }) => document !== entries[0]?.document);
  }

  get #isWritten(): boolean {
    return this.#written === this.#revision;
  }

  /** @param revision  what the store has of it */
  #follow(id: string, revision: number): void {
    this.#id = id;
    this.#revision = revision;
    this.#written = revision;
    this.#journalled = revision;
    this.#rememberInTab(id);
  }

  #rememberInTab(id: string): void {
    try {
      this.parts.tab.setItem(TAB_KEY, id);
    } catch {
      // Without storage a reload starts afresh, which the failed save has said already.
    }
  }

  /** Another tab has this document now, too: from here on it is one of its own. */
  #goOnAsCopy(): void {
    const id = this.parts.newId();
    void this.parts.claims.claim(id);
    this.#follow(id, this.#revision);
    if (this.#isOwn) this.touch();
  }

  #schedule(delay: number): void {
    const write = () => void this.flush();
    clearTimeout(this.#timer);
    this.#timer = setTimeout(write, delay);
    this.#deadline ??= setTimeout(write, LONGEST_DELAY);
  }

  #unschedule(): void {
    clearTimeout(this.#timer);
    clearTimeout(this.#deadline);
    this.#deadline = undefined;
  }

  async #save(id: string, kind: StoredDocument['kind']): Promise<void> {
    // A write that was asked for earlier may have taken this one's edits along.
    if (id !== this.#id || (kind === 'auto' && this.#isWritten)) return;
    const { state, messages } = this.parts;
    const revision = this.#revision;
    try {
      const time = await this.#write(id, kind);
      this.#failing = false;
      if (id !== this.#id) return;
      this.#written = revision;
      this.#kept.written(id);
      if (this.#journalled <= revision) this.#journal.remove(id);
      await this.#putBack(id);
      if (id !== this.#id) return;
      state.saved.value = this.#isWritten ? { kind: 'saved', time } : { kind: 'unsaved' };
    } catch (error) {
      const detail = error instanceof Error ? error.message : String(error);
      const message = t('error.autosave', { detail });
      if (!this.#failing) messages.toast('warn', message);
      this.#failing = true;
      if (id !== this.#id) return;
      state.saved.value = { kind: 'failed', message };
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => void this.flush(), RETRY);
    }
  }

  async #write(id: string, kind: StoredDocument['kind']): Promise<number> {
    const { document, state, store, now } = this.parts;
    const { recipe } = document;
    const revision = this.#revision;
    const from = Math.max(0, document.entries.length - MOST_ENTRIES);
    const index = Math.max(0, document.index - from);
    const entries = document.entries.slice(from);
    const recipes = entries.map((entry) => entry.document);
    const files = this.#filesOf(...recipes);
    const texts = await Promise.all(entries.map((entry) => hashedText(entry.document)));
    const time = now();
    const stored: StoredDocument = {
      id,
      revision,
      time,
      title: state.title.peek(),
      kind,
      ...(this.#link !== undefined && { link: this.#link }),
      entries: entries.map(({ selection, label, time }, i) => ({
        selection,
        label,
        time,
        recipe: texts[i]!.hash,
      })),
      index,
      files: this.#named(...recipes),
      ...countsOf(recipe),
    };
    await store.write(stored, new Map([...texts, ...files].map(({ hash, bytes }) => [hash, bytes])));
    for (const { hash } of files) this.#files.add(hash);
    await this.#prune(id).catch(() => {}); // the work is kept; too many restore points are not worth a message
    return time;
  }

  /** The store answers: it may have what it did not give when the document was opened. */
  async #putBack(id: string): Promise<void> {
    const before = this.#missing;
    if (before.length === 0) return;
    const missing = await this.#kept.putBack(before);
    if (id !== this.#id) return;
    this.#missing = missing;
    if (missing.length < before.length) this.parts.document.showAgain();
  }

  async #prune(current: string): Promise<void> {
    const all = [...(await this.parts.store.documents())].filter(({ id }) => id !== current);
    const old = all.sort((a, b) => b.time - a.time).slice(MOST_RESTORE_POINTS - 1);
    if (old.length > 0) await this.parts.store.remove(old.map(({ id }) => id));
  }

  /** The files that recipes name, and those that are missing. */
  #named(...recipes: readonly Recipe[]): KeptFile[] {
    return [...this.#filesOf(...recipes).map(({ file, hash }) => ({ file, hash })), ...this.#missing];
  }

  /** The opened files that recipes name. */
  #filesOf(...recipes: readonly Recipe[]) {
    const names = new Set(recipes.flatMap(fileNames));
    return [...names].map((name) => this.parts.models.get(name)).filter((file) => file !== undefined);
  }

  readonly #isNew = ({ hash }: { readonly hash: string }): boolean => !this.#files.has(hash);

  /** What a document holds by now that this tab has claimed; let go of again where nothing can be read, or a copy goes on. */
  async #claimed(
    known: StoredDocument,
  ): Promise<{ readonly stored: StoredDocument; readonly opened: Opened }> {
    const { claims } = this.parts;
    try {
      const stored = await this.#kept.newest(known);
      if (stored.id !== known.id) claims.release(known.id);
      return { stored, opened: await this.#kept.read(stored) };
    } catch (error) {
      claims.release(known.id);
      throw error;
    }
  }

  /** Goes on with a stored document under its own name, or under a new one while another tab has it. */
  async #lay(stored: StoredDocument, { entries, index, missing, isSilent, lost }: Opened): Promise<void> {
    const { claims, document, messages, newId, state } = this.parts;
    const { title, revision = 0 } = stored;
    const mine = await claims.claim(stored.id);
    this.#id = ''; // laying it open is no edit
    state.title.value = title;
    state.hint.value = null;
    document.restore(entries, index);
    this.#follow(mine ? stored.id : newId(), revision);
    this.#own = true;
    this.#missing = missing;
    this.#link = stored.link;
    this.settleAddress();
    if (!mine) {
      void claims.claim(this.#id);
      this.touch();
    } else if (this.#kept.isUnwritten(stored.id)) {
      this.#written = -1;
      state.saved.value = { kind: 'unsaved' };
      this.#schedule(0);
    } else state.saved.value = { kind: 'saved', time: stored.time };
    if (missing.length > 0) {
      const files = missing.map(({ file }) => file).join(', ');
      messages.toast('warn', t(isSilent ? 'toast.files-later' : 'toast.files-gone', { title, files }));
    }
    if (lost > 0) messages.toast('warn', t('toast.states-gone', { title, count: lost }));
  }
}

const fileNames = (recipe: Recipe): string[] =>
  Object.values(recipe.models).flatMap((ref) => ('file' in ref ? [ref.file] : []));
