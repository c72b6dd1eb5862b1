import { replaceStep, stepOf } from '../../recipe/edit';
import type { CurvesStep } from '../../recipe/recipe';
import { type Grip, itemOf } from '../../tools/curves/items';
import type { Document } from '../document';
import { LiveEdit } from '../live-edit';

/** What all edits of the open curves step have in common: one step of undo each, or a preview that is finished later. */
export class CurvesEdits {
  readonly #live: LiveEdit;

  constructor(private readonly document: Document) {
    this.#live = new LiveEdit(document);
  }

  /** The committed open step while it is one of curves. */
  get step(): CurvesStep | undefined {
    return stepOf(this.document.recipe, this.document.selection.step, 'curves');
  }

  /** @param grip  selected afterwards; as before when left out */
  commit(label: string, step: CurvesStep, grip?: Grip | null): void {
    if (step !== this.step)
      this.document.commit(label, replaceStep(this.document.recipe, step), this.#selecting(step, grip));
  }

  preview(label: string, step: CurvesStep, grip?: Grip | null): void {
    this.#live.preview(label, replaceStep(this.document.recipe, step), this.#selecting(step, grip));
  }

  finish(): void {
    this.#live.finish();
  }

  cancel(): void {
    this.#live.cancel();
  }

  #selecting(step: CurvesStep, grip: Grip | null | undefined) {
    const item = grip === undefined ? this.document.selection.item : grip && itemOf(grip);
    return { step: step.id, item };
  }
}
