import { replaceStep } from '../../recipe/edit';
import type { DressStep } from '../../recipe/recipe';
import type { Document } from '../document';
import { StepEdits } from '../step-edits';

export class DressEdits extends StepEdits<'dress'> {
  constructor(document: Document) {
    super(document, 'dress');
  }

  commit(label: string, step: DressStep): void {
    const { document } = this;
    document.commit(label, replaceStep(document.recipe, step), { step: step.id, item: null });
  }

  preview(label: string, step: DressStep): void {
    const { document } = this;
    this.live.preview(label, replaceStep(document.recipe, step), document.selection);
  }
}
