import type { Recipe } from '../recipe/recipe';
import type { Document } from './document';
import type { Selection } from './state';

/** An edit that is shown while a control moves, until it is finished under a name or cancelled. */
export class LiveEdit {
  #label = '';

  constructor(private readonly document: Document) {}

  preview(label: string, recipe: Recipe, selection: Selection): void {
    this.#label = label;
    this.document.preview(recipe, selection);
  }

  finish(): void {
    if (this.#label) this.document.finish(this.#label);
    this.#label = '';
  }

  cancel(): void {
    this.#label = '';
    this.document.cancel();
  }
}
