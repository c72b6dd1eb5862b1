import { putStep } from '../../recipe/edit';
import type { CurvesStep } from '../../recipe/recipe';
import { type Grip, itemOf } from '../../tools/curves/items';
import type { Document } from '../document';
import { StepEdits } from '../step-edits';

export class CurvesEdits extends StepEdits<'curves'> {
  constructor(document: Document) {
    super(document, 'curves');
  }

  /** @param grip  selected afterwards; as before when left out */
  commit(label: string, step: CurvesStep, grip?: Grip | null): void {
    if (step !== this.step)
      this.document.commit(label, putStep(this.document.recipe, step), this.#selecting(step, grip));
  }

  preview(label: string, step: CurvesStep, grip?: Grip | null): void {
    this.live.preview(label, putStep(this.document.recipe, step), this.#selecting(step, grip));
  }

  #selecting(step: CurvesStep, grip: Grip | null | undefined) {
    const item = grip === undefined ? this.document.selection.item : grip && itemOf(grip);
    return { step: step.id, item };
  }
}
