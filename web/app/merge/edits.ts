import type { MergeStep } from '../../recipe/recipe';
import type { Document } from '../document';
import { LiveEdit } from '../live-edit';
import type { State } from '../state';
import { mergeStepById, withMergeStep } from './steps';

export interface EditParts {
  readonly state: State;
  readonly document: Document;
}

/** What all edits of the open merge step have in common: one step of undo each, or a preview that is finished later. */
export abstract class MergeEdits {
  readonly #live: LiveEdit;

  constructor(protected readonly parts: EditParts) {
    this.#live = new LiveEdit(parts.document);
  }

  protected get step(): MergeStep | undefined {
    const { document } = this.parts;
    return mergeStepById(document.recipe, document.selection.step);
  }

  finish(): void {
    this.#live.finish();
  }

  cancel(): void {
    this.#live.cancel();
  }

  protected set(label: string, step: MergeStep, live: boolean, merge: string): void {
    const { document } = this.parts;
    if (live) this.#live.preview(label, withMergeStep(document.recipe, step), document.selection);
    else this.commit(label, step, document.selection.handle, `merge:${merge}`);
  }

  protected commit(label: string, step: MergeStep, handle: number | null = null, merge?: string): void {
    const { document } = this.parts;
    document.commit(label, withMergeStep(document.recipe, step), { step: step.id, handle }, merge);
  }
}
