import { replaceStep } from '../../recipe/edit';
import type { MatchStep } from '../../recipe/recipe';
import type { Document } from '../document';
import { StepEdits } from '../step-edits';
import type { MatchState } from './state';

/** Edits wait for their button: what was matched before stays on screen. */
export class MatchEdits extends StepEdits<'match'> {
  constructor(
    document: Document,
    private readonly own: Pick<MatchState, 'hold' | 'ask' | 'result'>,
  ) {
    super(document, 'match');
  }

  commit(label: string, step: MatchStep, item = this.document.selection.item): void {
    const { document } = this;
    this.#hold(step);
    document.commit(label, replaceStep(document.recipe, step), { step: step.id, item });
  }

  preview(label: string, step: MatchStep, item = this.document.selection.item): void {
    const { document } = this;
    this.#hold(step);
    this.live.preview(label, replaceStep(document.recipe, step), { step: step.id, item });
  }

  /** What has been matched already may be matched again: undo leads back to it at once. */
  #hold({ id }: MatchStep): void {
    const result = this.own.result.peek();
    if (result?.of.id === id) this.own.ask(result.of);
    this.own.hold(id);
  }
}
