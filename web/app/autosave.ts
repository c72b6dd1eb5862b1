// Keeps the work in the browser a second after each edit, with its undo history, and brings it back after a
// reload or a crash. Every document that is opened gets a restore point of its own; the last 20 are kept.

import { formatRecipe } from '../recipe/format';
import { parseRecipe } from '../recipe/parse';
import type { Recipe } from '../recipe/recipe';
import type { AutosaveService, MessageService, RestorePoint } from './api';
import type { Document, Entry } from './document';
import { t } from './i18n';
import { type ModelStore, sha256 } from './model-store';
import type { State } from './state';
import type { DocumentStore, StoredDocument } from './store';
import type { Claims } from './tab-claim';

export const MOST_RESTORE_POINTS = 20;
/** Undo steps that survive a reload. */
const MOST_ENTRIES = 200;
const DELAY = 1000;

export interface AutosaveParts {
  readonly state: State;
  readonly document: Document;
  readonly models: ModelStore;
  readonly store: DocumentStore;
  readonly claims: Claims;
  readonly messages: MessageService;
  /** Of this tab, lasting over reloads. */
  readonly tab: Pick<Storage, 'getItem' | 'setItem'>;
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
  #timer: ReturnType<typeof setTimeout> | undefined;
  #writing: Promise<void> = Promise.resolve();
  #asked = false;
  /** Hash and bytes of a recipe's text: recipes never change in place. */
  readonly #texts = new WeakMap<Recipe, Promise<{ readonly hash: string; readonly bytes: Uint8Array }>>();

  constructor(private readonly parts: AutosaveParts) {
    parts.document.onCommit(() => {
      if (this.#isOwn) this.touch();
    });
  }

  /** A new document: what was kept of the last one stays. */
  begin({ own, link }: { readonly own: boolean; readonly link?: string | undefined }): void {
    this.#follow(this.parts.newId());
    void this.parts.claims.claim(this.#id);
    this.#own = own;
    this.#link = link;
    this.parts.state.saved.value = { kind: 'clean' };
  }

  /** Marks the document as to be saved. */
  touch(): void {
    this.parts.state.saved.value = { kind: 'unsaved' };
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.flush(), DELAY);
    if (this.#asked) return;
    this.#asked = true;
    this.parts.persist();
  }

  /** Writes now what waits to be written. Never throws: what went wrong is in `state.saved`. */
  flush(kind: StoredDocument['kind'] = 'auto'): Promise<void> {
    clearTimeout(this.#timer);
    const { saved } = this.parts.state;
    if (this.#id === '' || !this.#isOwn || (saved.peek().kind === 'saved' && kind === 'auto'))
      return this.#writing;
    const id = this.#id;
    saved.value = { kind: 'saving' };
    this.#writing = this.#writing.then(async () => {
      try {
        const time = await this.#write(id, kind);
        if (saved.peek().kind === 'saving') saved.value = { kind: 'saved', time };
      } catch (error) {
        const message = t('error.autosave', {
          detail: error instanceof Error ? error.message : String(error),
        });
        if (saved.peek().kind !== 'failed') this.parts.messages.toast('warn', message);
        saved.value = { kind: 'failed', message };
      }
    });
    return this.#writing;
  }

  /** Before another document takes its place. @returns whether there was work of one's own to keep */
  async setAside(): Promise<boolean> {
    const isOwn = this.#id !== '' && this.#isOwn;
    if (isOwn) await this.flush('kept');
    this.parts.claims.release(this.#id);
    this.#id = '';
    return isOwn;
  }

  async restorePoints(): Promise<readonly RestorePoint[]> {
    await this.flush();
    const all = [...(await this.parts.store.documents())].sort((a, b) => b.time - a.time);
    return all.map(({ id, time, title, steps, handles, kind }) => {
      return { id, time, title, steps, handles, kind, current: id === this.#id };
    });
  }

  async restore(id: string): Promise<void> {
    if (id === this.#id) return;
    const stored = await this.parts.store.document(id);
    if (!stored) return;
    const opened = await this.#read(stored);
    if (await this.setAside()) this.parts.messages.toast('info', t('toast.kept'));
    await this.#lay(stored, opened);
  }

  /**
   * What this tab had before it was reloaded, or what a closed one left behind.
   * @param link  the address opened now: its own stored changes go before it, no others do
   */
  async restoreLast(link?: string): Promise<boolean> {
    const all = [...(await this.parts.store.documents())].sort((a, b) => b.time - a.time);
    const mine = all.find(({ id }) => id === this.parts.tab.getItem(TAB_KEY));
    const candidates = link
      ? all.filter((each) => each === mine && each.link === link)
      : [mine, ...all.filter((each) => each.kind === 'auto')].filter((each) => each !== undefined);
    for (const stored of candidates) {
      if (!(await this.parts.claims.claim(stored.id))) continue;
      try {
        await this.#lay(stored, await this.#read(stored));
        return true;
      } catch (error) {
        this.parts.claims.release(stored.id);
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

  #follow(id: string): void {
    this.#id = id;
    try {
      this.parts.tab.setItem(TAB_KEY, id);
    } catch {
      // Without storage a reload starts afresh, which the failed save has said already.
    }
  }

  async #write(id: string, kind: StoredDocument['kind']): Promise<number> {
    const { document, models, state, store, now } = this.parts;
    const from = Math.max(0, document.entries.length - MOST_ENTRIES);
    const entries = document.entries.slice(from);
    const texts = await Promise.all(entries.map((entry) => this.#text(entry.document)));
    const names = new Set(entries.flatMap((entry) => fileNames(entry.document)));
    const files = [...names].map((name) => models.get(name)).filter((file) => file !== undefined);
    const bytes = new Map([
      ...texts.map((text) => [text.hash, text.bytes] as const),
      ...files.map((file) => [file.hash, file.bytes] as const),
    ]);
    const missing = await store.missing(bytes.keys());
    const { recipe } = document;
    const time = now();
    const stored: StoredDocument = {
      id,
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
      index: Math.max(0, document.index - from),
      files: files.map(({ file, hash }) => ({ file, hash })),
      steps: recipe.steps.length,
      handles: recipe.steps.reduce((sum, step) => sum + ('handles' in step ? step.handles.length : 0), 0),
    };
    await store.write(stored, new Map(missing.map((hash) => [hash, bytes.get(hash)!])));
    await this.#prune(id);
    return time;
  }

  async #prune(current: string): Promise<void> {
    const all = [...(await this.parts.store.documents())].filter(({ id }) => id !== current);
    const old = all.sort((a, b) => b.time - a.time).slice(MOST_RESTORE_POINTS - 1);
    if (old.length > 0) await this.parts.store.remove(old.map(({ id }) => id));
  }

  #text(recipe: Recipe): Promise<{ hash: string; bytes: Uint8Array }> {
    let text = this.#texts.get(recipe);
    if (!text) {
      const bytes = new TextEncoder().encode(formatRecipe(recipe));
      text = sha256(bytes).then((hash) => ({ hash, bytes }));
      this.#texts.set(recipe, text);
    }
    return text;
  }

  async #read(stored: StoredDocument): Promise<readonly Entry[]> {
    const { store, models } = this.parts;
    for (const { file, hash } of stored.files) {
      const bytes = await store.blob(hash);
      if (bytes) models.put({ file, hash, bytes });
    }
    const recipes = new Map<string, Recipe>();
    const entries: Entry[] = [];
    for (const { recipe: hash, selection, label, time } of stored.entries) {
      if (!recipes.has(hash)) {
        const bytes = await store.blob(hash);
        if (!bytes) continue;
        recipes.set(hash, parseRecipe(new TextDecoder().decode(bytes)));
      }
      entries.push({ document: recipes.get(hash)!, selection, label, time });
    }
    return entries;
  }

  /** Goes on with a stored document under its own name, or under a new one while another tab has it. */
  async #lay(stored: StoredDocument, entries: readonly Entry[]): Promise<void> {
    const { claims, document, newId, state } = this.parts;
    const mine = await claims.claim(stored.id);
    this.#follow(mine ? stored.id : newId());
    this.#own = true;
    this.#link = stored.link;
    state.title.value = stored.title;
    state.hint.value = null;
    document.restore(entries, stored.index);
    clearTimeout(this.#timer);
    state.saved.value = mine ? { kind: 'saved', time: stored.time } : { kind: 'unsaved' };
    if (!mine) this.touch();
  }
}

const fileNames = (recipe: Recipe): string[] =>
  Object.values(recipe.models).flatMap((ref) => ('file' in ref ? [ref.file] : []));
