// Choosing the part to add. Until it is chosen nothing has happened to the recipe; with it the merge step begins.

import * as edit from '../../recipe/edit';
import type { ModelRef } from '../../recipe/recipe';
import { newMergeStep } from '../../recipe/steps/merge';
import type { Runner } from '../../run/evaluate';
import type { Document } from '../document';
import { t } from '../i18n';
import type { State } from '../state';
import { mergeStepById, withMark, withMergeStep } from './steps';

interface Parts {
  readonly state: State;
  readonly document: Document;
  readonly runner: Pick<Runner, 'opened'>;
}

export class PartChoice {
  constructor(private readonly parts: Parts) {}

  /** @param swaps  id of the merge step that shall have another part; `null`: a new step begins */
  async ask(target: string, swaps: string | null): Promise<void> {
    const { state, document, runner } = this.parts;
    const { recipe } = document;
    const opened = await runner.opened(recipe, target);
    if (document.recipe !== recipe) return;
    state.merge.opened.value = { source: null, target: { name: target, result: opened } };
    state.merge.choosing.value = { recipe, target, swaps };
  }

  async cancel(): Promise<void> {
    const { state, document, runner } = this.parts;
    state.merge.choosing.value = null;
    const { recipe } = document;
    const step = mergeStepById(recipe, document.selection.step);
    if (!step) return;
    // The part that was there is shown again.
    const source = await runner.opened(recipe, step.source);
    const target = await runner.opened(recipe, step.target);
    if (document.recipe !== recipe) return;
    state.merge.opened.value = {
      source: { name: step.source, result: source },
      target: { name: step.target, result: target },
    };
  }

  choose(name: string, ref: ModelRef): void {
    const { state, document } = this.parts;
    const choosing = state.merge.choosing.peek();
    if (!choosing || !state.choosing.peek()) return;
    const held = document.recipe.models[name];
    const isHeld = held !== undefined && sameRef(held, ref);
    const source = isHeld ? name : edit.uniqueName(name, edit.takenNames(document.recipe));
    const named = isHeld ? document.recipe : edit.setModel(document.recipe, source, ref);
    const swapped = mergeStepById(named, choosing.swaps ?? '');
    const id = swapped?.id ?? freeId(edit.takenNames(named));
    const bare = newMergeStep(id, source, choosing.target);
    // What is marked on the target holds for another part too.
    const targetRegion = swapped?.optimalBoundary?.targetRegion;
    const step = targetRegion ? withMark(bare, 'target', targetRegion) : bare;
    const recipe = swapped ? edit.pruneModels(withMergeStep(named, step)) : edit.addStep(named, step);
    state.merge.held.value = id;
    document.commit(t('history.merge.start', { name: source }), recipe, { step: id, handle: null });
    state.merge.choosing.value = null;
    state.tool.value = 'mark-region';
  }
}

const sameRef = (a: ModelRef, b: ModelRef): boolean =>
  'file' in a ? 'file' in b && a.file === b.file : 'builtin' in b && a.builtin === b.builtin;

/** `merge 1`, `merge 2` … */
function freeId(taken: readonly string[]): string {
  for (let number = 1; ; number++) if (!taken.includes(`merge ${number}`)) return `merge ${number}`;
}
