import { stepOf } from '../recipe/edit';
import type { StepOf, StepType } from '../recipe/recipe';
import type { Document } from './document';
import { LiveEdit } from './live-edit';

/** What all edits of an open step have in common: one step of undo each, or a preview that is finished later. */
export class StepEdits<T extends StepType> {
  protected readonly live: LiveEdit;

  constructor(
    protected readonly document: Document,
    private readonly type: T,
  ) {
    this.live = new LiveEdit(document);
  }

  /** The committed open step while it is one of this type. */
  get step(): StepOf<T> | undefined {
    return stepOf(this.document.recipe, this.document.selection.step, this.type);
  }

  finish(): void {
    this.live.finish();
  }

  cancel(): void {
    this.live.cancel();
  }
}
