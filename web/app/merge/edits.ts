import { replaceStep } from '../../recipe/edit';
import type { MergeStep } from '../../recipe/recipe';
import type { Document } from '../document';
import { StepEdits } from '../step-edits';

export class MergeEdits extends StepEdits<'merge'> {
  constructor(document: Document) {
    super(document, 'merge');
  }

  /** `live` previews (slider held), then `finish`. */
  set(label: string, step: MergeStep, live: boolean, merge: string): void {
    const { document } = this;
    if (live) this.live.preview(label, replaceStep(document.recipe, step), document.selection);
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
