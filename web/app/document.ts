// The document over time: recipe and selection, committed by edits and previewed by gestures. Keeps the
// state's signals in step with the history, whoever changed it.

import { batch } from '@preact/signals';
import * as edit from '../recipe/edit';
import { History, type HistoryEntry } from '../recipe/history';
import type { Recipe } from '../recipe/recipe';
import type { DocumentService } from './api';
import { t } from './i18n';
import type { Selection, Snapshot, State } from './state';

export type Entry = HistoryEntry<Recipe, Selection>;

export const EMPTY_RECIPE: Recipe = { lissom: 1, models: {}, steps: [], outputs: [] };
const NOTHING: Selection = { step: '', item: null };

export const EMPTY: Snapshot = { recipe: EMPTY_RECIPE, selection: NOTHING };

/** The last step, nothing selected: how a recipe opens. */
export const openingSelection = (recipe: Recipe): Selection => ({
  step: recipe.steps.at(-1)?.id ?? '',
  item: null,
});

export class Document implements DocumentService {
  #history = new History<Recipe, Selection>(EMPTY_RECIPE, NOTHING);
  #unsubscribe = () => {};
  readonly #committed = new Set<() => void>();
  #last: Recipe = EMPTY_RECIPE;

  constructor(private readonly state: State) {
    this.#follow(this.#history);
  }

  /** The committed recipe: what is saved, shared and undone. */
  get recipe(): Recipe {
    return this.#history.document;
  }

  get selection(): Selection {
    return this.#history.selection;
  }

  get isDirty(): boolean {
    return this.#history.isDirty;
  }

  get entries(): readonly Entry[] {
    return this.#history.entries;
  }

  get index(): number {
    return this.#history.index;
  }

  /** Another document takes the place of this one, with a history of its own. */
  replace(recipe: Recipe, label: string, selection = openingSelection(recipe)): void {
    this.#lay(new History(recipe, selection, label));
  }

  /** As `replace`, with the history it had: older entries first, `index` the one to show. */
  restore(entries: readonly Entry[], index: number): void {
    const [first, ...rest] = entries;
    if (!first) return;
    const times = entries.map(({ time }) => time);
    const clock = () => times.shift() ?? Date.now();
    const history = new History(first.document, first.selection, first.label, clock);
    for (const { document, selection, label } of rest) history.commit(label, document, selection);
    history.jump(index);
    history.markSaved();
    this.#lay(history);
  }

  /** What is shown is computed anew where that failed: files that it names may be there by now. */
  showAgain(): void {
    this.state.shown.value = { ...this.state.shown.peek() };
  }

  preview(recipe: Recipe, selection: Selection): void {
    this.#history.preview(recipe, selection);
  }

  /** @param series  edits of one in quick succession are one step of undo */
  commit(label: string, recipe: Recipe, selection: Selection = this.selection, series?: string): void {
    this.#history.commit(label, recipe, selection, series === undefined ? {} : { series });
  }

  /** Commits what is previewed. */
  finish(label: string): void {
    if (this.#history.isPreviewing) this.#history.finish(label);
  }

  cancel(): void {
    this.#history.cancel();
  }

  markSaved(recipe: Recipe): void {
    this.#history.markSaved(recipe);
  }

  undo(): void {
    this.#history.undo();
  }

  redo(): void {
    this.#history.redo();
  }

  openStep(id: string): void {
    this.#select({ step: id, item: null });
  }

  select(item: number | null): void {
    this.#select({ step: this.selection.step, item });
  }

  removeStep(id: string): void {
    const recipe = edit.removeStep(this.recipe, id);
    const selection = id === this.selection.step ? openingSelection(recipe) : this.selection;
    this.commit(t('history.remove-step'), recipe, selection);
  }

  /** @returns the function that unsubscribes; `listener` is called after each change of the committed recipe */
  onCommit(listener: () => void): () => void {
    this.#committed.add(listener);
    return () => this.#committed.delete(listener);
  }

  #select(selection: Selection): void {
    const { step, item } = this.selection;
    if (step === selection.step && item === selection.item) return;
    // A selection would cut off what redo could still bring back, so until then it is only shown.
    if (this.#history.canRedo) this.#history.preview(this.recipe, selection);
    else this.#history.commit(t('history.select'), this.recipe, selection, { series: 'select' });
  }

  #lay(history: History<Recipe, Selection>): void {
    batch(() => {
      this.#follow(history);
      this.state.opened.value++;
    });
  }

  #follow(history: History<Recipe, Selection>): void {
    this.#unsubscribe();
    this.#history = history;
    this.#unsubscribe = history.subscribe(() => this.#publish());
    this.#publish();
  }

  #publish(): void {
    const history = this.#history;
    const { shown, selection } = history;
    batch(() => {
      const before = this.state.shown.peek();
      if (before.recipe !== shown || before.selection !== selection)
        this.state.shown.value = { recipe: shown, selection };
      this.state.previewing.value = shown !== history.document;
      this.state.canUndo.value = history.canUndo;
      this.state.canRedo.value = history.canRedo;
      this.state.undoLabel.value = history.undoLabel ?? '';
      this.state.redoLabel.value = history.redoLabel ?? '';
    });
    if (history.document === this.#last) return;
    this.#last = history.document;
    for (const listener of this.#committed) listener();
  }
}
