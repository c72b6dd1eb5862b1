import { replaceStep } from '../../recipe/edit';
import type { TransferStep } from '../../recipe/recipe';
import type { Document } from '../document';
import { StepEdits } from '../step-edits';

export class TransferEdits extends StepEdits<'transfer'> {
  constructor(document: Document) {
    super(document, 'transfer');
  }

  commit(label: string, step: TransferStep, item = this.document.selection.item): void {
    const { document } = this;
    document.commit(label, replaceStep(document.recipe, step), { step: step.id, item });
  }

  preview(label: string, step: TransferStep): void {
    const { document } = this;
    this.live.preview(label, replaceStep(document.recipe, step), document.selection);
  }
}
