import { replaceStep } from '../../recipe/edit';
import type { BlendStep } from '../../recipe/recipe';
import type { Document } from '../document';
import { StepEdits } from '../step-edits';

export class BlendEdits extends StepEdits<'blend'> {
  constructor(document: Document) {
    super(document, 'blend');
  }

  commit(label: string, step: BlendStep, item = this.document.selection.item): void {
    const { document } = this;
    document.commit(label, replaceStep(document.recipe, step), { step: step.id, item });
  }

  preview(label: string, step: BlendStep): void {
    const { document } = this;
    this.live.preview(label, replaceStep(document.recipe, step), document.selection);
  }

  /** As a control says: while it moves, or once. */
  put(label: string, step: BlendStep, live: boolean): void {
    if (live) this.preview(label, step);
    else this.commit(label, step);
  }
}
