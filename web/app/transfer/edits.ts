import { replaceStep, stepOf } from '../../recipe/edit';
import type { TransferStep } from '../../recipe/recipe';
import type { Document } from '../document';
import { LiveEdit } from '../live-edit';

/** What all edits of the open transfer step have in common: one step of undo each, or a preview that is finished later. */
export class TransferEdits {
  readonly #live: LiveEdit;

  constructor(private readonly document: Document) {
    this.#live = new LiveEdit(document);
  }

  /** The committed open step while it is one that transfers. */
  get step(): TransferStep | undefined {
    return stepOf(this.document.recipe, this.document.selection.step, 'transfer');
  }

  commit(label: string, step: TransferStep, item = this.document.selection.item): void {
    const { document } = this;
    document.commit(label, replaceStep(document.recipe, step), { step: step.id, item });
  }

  preview(label: string, step: TransferStep): void {
    const { document } = this;
    this.#live.preview(label, replaceStep(document.recipe, step), document.selection);
  }

  finish(): void {
    this.#live.finish();
  }
}
