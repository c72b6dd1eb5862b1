import { replaceStep, stepOf } from '../../recipe/edit';
import type { MergeStep } from '../../recipe/recipe';
import type { Document } from '../document';
import { LiveEdit } from '../live-edit';

/** What all edits of the open merge step have in common: one step of undo each, or a preview that is finished later. */
export class MergeEdits {
  readonly #live: LiveEdit;

  constructor(private readonly document: Document) {
    this.#live = new LiveEdit(document);
  }

  /** The committed open step while it is one that merges. */
  get step(): MergeStep | undefined {
    return stepOf(this.document.recipe, this.document.selection.step, 'merge');
  }

  finish(): void {
    this.#live.finish();
  }

  cancel(): void {
    this.#live.cancel();
  }

  /** `live` previews (slider held), then `finish`. */
  set(label: string, step: MergeStep, live: boolean, merge: string): void {
    const { document } = this;
    if (live) this.#live.preview(label, replaceStep(document.recipe, step), document.selection);
    else this.commit(label, step, document.selection.item, `merge:${merge}`);
  }

  commit(label: string, step: MergeStep, item: number | null = null, merge?: string): void {
    const { document } = this;
    document.commit(label, replaceStep(document.recipe, step), { step: step.id, item }, merge);
  }

  preview(step: MergeStep, item: number | null): void {
    const { document } = this;
    document.preview(replaceStep(document.recipe, step), { step: step.id, item });
  }
}
