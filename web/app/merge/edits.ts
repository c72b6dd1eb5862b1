import type { MergeStep } from '../../recipe/recipe';
import type { Document } from '../document';
import type { State } from '../state';
import { mergeStepById, withMergeStep } from './steps';

export interface EditParts {
  readonly state: State;
  readonly document: Document;
}

/** What all edits of the open merge step have in common: one step of undo each, or a preview that is finished later. */
export abstract class MergeEdits {
  /** What `finish` will call the edit under way. */
  #live = '';

  constructor(protected readonly parts: EditParts) {}

  protected get step(): MergeStep | undefined {
    const { document } = this.parts;
    return mergeStepById(document.recipe, document.selection.step);
  }

  finish(): void {
    if (this.#live) this.parts.document.finish(this.#live);
    this.#live = '';
  }

  cancel(): void {
    this.#live = '';
    this.parts.document.cancel();
  }

  protected set(label: string, step: MergeStep, live: boolean, merge: string): void {
    const { document } = this.parts;
    if (live) {
      this.#live = label;
      document.preview(withMergeStep(document.recipe, step), document.selection);
    } else this.commit(label, step, document.selection.handle, `merge:${merge}`);
  }

  protected commit(label: string, step: MergeStep, handle: number | null = null, merge?: string): void {
    const { document } = this.parts;
    document.commit(label, withMergeStep(document.recipe, step), { step: step.id, handle }, merge);
  }
}
