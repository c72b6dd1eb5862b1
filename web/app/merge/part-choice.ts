// Choosing the part to add. Until it is chosen nothing has happened to the recipe; with it the merge step begins.

import * as edit from '../../recipe/edit';
import type { ModelRef } from '../../recipe/recipe';
import { newMergeStep } from '../../recipe/steps/merge';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { MergeState } from './state';
import { withMark } from './steps';

type Parts = Pick<WingParts, 'state' | 'document' | 'runner'>;

export class PartChoice {
  constructor(
    private readonly parts: Parts,
    private readonly own: MergeState,
  ) {}

  /** Asks for the part to add to a model or a step's result. */
  start(target: string): Promise<void> {
    return this.#ask(target, null);
  }

  /** Asks for another part. */
  async change(): Promise<void> {
    const { document } = this.parts;
    const step = edit.stepOf(document.recipe, document.selection.step, 'merge');
    if (step) await this.#ask(step.target, step.id);
  }

  cancel(): void {
    this.parts.state.choice.value = null;
  }

  /** @param swaps  id of the merge step that gets another part; `null`: a new step begins */
  async #ask(target: string, swaps: string | null): Promise<void> {
    const { state, document, runner } = this.parts;
    const { recipe } = document;
    const opened = await runner.opened(recipe, target);
    if (document.recipe !== recipe) return;
    this.own.target.value = opened;
    const choose = (name: string, ref: ModelRef) => this.#choose(name, ref, target, swaps);
    state.choice.value = { recipe, workspace: 'merge', drop: 'ui.drop.part', choose };
  }

  #choose(name: string, ref: ModelRef, target: string, swaps: string | null): void {
    const { state, document } = this.parts;
    if (!state.choosing.peek()) return;
    const { recipe: before, name: source } = edit.withModel(document.recipe, name, ref);
    const swapped = edit.stepOf(before, swaps ?? '', 'merge');
    const id = swapped?.id ?? edit.freeId('merge', before);
    const bare = newMergeStep(id, source, target);
    // What is marked on the target holds for another part too.
    const targetRegion = swapped?.optimalBoundary?.targetRegion;
    const step = targetRegion ? withMark(bare, 'target', targetRegion) : bare;
    const recipe = swapped ? edit.pruneModels(edit.replaceStep(before, step)) : edit.addStep(before, step);
    this.own.hold(id);
    document.commit(t('history.merge.start', { name: source }), recipe, { step: id, item: null });
    state.choice.value = null;
    state.tool.value = 'mark-region';
  }
}
