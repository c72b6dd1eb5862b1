// The document over time. Documents are immutable, so undo is an older document: there are no inverse
// operations to get wrong, and what did not change is shared between entries.

/** One state the user can come back to. */
export interface HistoryEntry<D, S> {
  readonly document: D;
  readonly selection: S;
  /** What was done, as menus and the history list show it. */
  readonly label: string;
  /** Milliseconds since 1970. */
  readonly time: number;
}

export interface CommitOptions {
  /** Edits of one key in quick succession (typing a number) are one entry. */
  readonly series?: string;
}

/** Edits of one `series` further apart than this stay apart. */
const MERGE_MILLISECONDS = 1500;

/**
 * @typeParam D  document; compared by identity, never changed in place
 * @typeParam S  what is selected: part of an entry, so undo brings it back, but never makes a document dirty
 */
export class History<D, S> {
  #entries: readonly HistoryEntry<D, S>[];
  #index = 0;
  #preview: { readonly document: D; readonly selection: S } | undefined;
  #gesture: string | undefined;
  #series: string | undefined;
  #saved: D;
  readonly #listeners = new Set<() => void>();

  constructor(
    document: D,
    selection: S,
    label = 'Open',
    private readonly now: () => number = Date.now,
  ) {
    this.#entries = [{ document, selection, label, time: now() }];
    this.#saved = document;
  }

  get entries(): readonly HistoryEntry<D, S>[] {
    return this.#entries;
  }

  get index(): number {
    return this.#index;
  }

  get current(): HistoryEntry<D, S> {
    return this.#entries[this.#index]!;
  }

  /** The committed document: what is saved, shared and undone. */
  get document(): D {
    return this.current.document;
  }

  /** What the views draw: the preview of a gesture under way, else the committed document. */
  get shown(): D {
    return this.#preview ? this.#preview.document : this.document;
  }

  get selection(): S {
    return this.#preview ? this.#preview.selection : this.current.selection;
  }

  get canUndo(): boolean {
    return this.#index > 0;
  }

  get canRedo(): boolean {
    return this.#index < this.#entries.length - 1;
  }

  /** Labels of what undo would take back and redo would do again. */
  get undoLabel(): string | undefined {
    return this.canUndo ? this.current.label : undefined;
  }

  get redoLabel(): string | undefined {
    return this.#entries[this.#index + 1]?.label;
  }

  /** Whether the committed document is another than the one last saved; a count of steps would not do. */
  get isDirty(): boolean {
    return this.document !== this.#saved;
  }

  /** Whether a gesture is under way: its previews are drawn, but not yet history. */
  get isPreviewing(): boolean {
    return this.#preview !== undefined || this.#gesture !== undefined;
  }

  /** Starts a gesture that `commit` will name `label` unless told otherwise; an earlier one is cancelled. */
  begin(label: string): void {
    this.#preview = undefined;
    this.#gesture = label;
    this.#changed();
  }

  preview(document: D, selection: S = this.selection): void {
    this.#preview = { document, selection };
    this.#changed();
  }

  /** Ends a gesture without a trace. */
  cancel(): void {
    if (!this.isPreviewing) return;
    this.#preview = undefined;
    this.#gesture = undefined;
    this.#changed();
  }

  /** Ends a gesture with what it last previewed as one entry; without a preview nothing is added. */
  finish(label = this.#gesture ?? 'Edit'): void {
    const { shown, selection } = this;
    this.commit(label, shown, selection);
  }

  /** Adds an entry after the current one, in place of what was undone. The same state twice adds nothing. */
  commit(label: string, document: D, selection: S = this.selection, options: CommitOptions = {}): void {
    this.#preview = undefined;
    this.#gesture = undefined;
    const { current } = this;
    if (document !== current.document || selection !== current.selection) {
      const entry = { document, selection, label, time: this.now() };
      const merged = this.#continues(entry, options.series);
      this.#entries = [...this.#entries.slice(0, this.#index + (merged ? 0 : 1)), entry];
      this.#index = this.#entries.length - 1;
      this.#series = options.series;
    }
    this.#changed();
  }

  undo(): void {
    this.jump(this.#index - 1);
  }

  redo(): void {
    this.jump(this.#index + 1);
  }

  /** Goes to an entry of the list, or to the nearest end of it; ends any gesture without a trace. */
  jump(index: number): void {
    this.#index = Math.min(Math.max(index, 0), this.#entries.length - 1);
    this.#preview = undefined;
    this.#gesture = undefined;
    this.#series = undefined;
    this.#changed();
  }

  /** @param document  what was written; edits may have been made while it was */
  markSaved(document: D = this.document): void {
    this.#saved = document;
    this.#series = undefined;
    this.#changed();
  }

  /** @returns the function that unsubscribes */
  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #continues(entry: HistoryEntry<D, S>, key: string | undefined): boolean {
    const quick = entry.time - this.current.time <= MERGE_MILLISECONDS;
    return key !== undefined && key === this.#series && quick && !this.canRedo && this.canUndo;
  }

  #changed(): void {
    for (const listener of [...this.#listeners]) listener();
  }
}
