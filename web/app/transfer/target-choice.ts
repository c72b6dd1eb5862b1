// Choosing the model that gets the pose. Until it is chosen nothing has happened to the recipe.

import { LissomError } from '../../core/errors';
import * as edit from '../../recipe/edit';
import type { ModelRef } from '../../recipe/recipe';
import { newTransferStep } from '../../recipe/steps/transfer';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { Follow } from './follow';
import { firstPose, poseOf } from './poses';
import type { TransferState } from './state';

export class TargetChoice {
  constructor(
    private readonly parts: Pick<WingParts, 'state' | 'document'>,
    private readonly own: TransferState,
    private readonly follow: Pick<Follow, 'source'>,
  ) {}

  /** @throws LissomError `transfer-no-pose` where no model has a pose */
  async start(): Promise<void> {
    const { recipe, selection } = this.parts.document;
    const step = edit.stepOf(recipe, selection.step, 'transfer');
    const pose = (step && poseOf(recipe, step)) ?? firstPose(recipe, selection.step);
    if (!pose) throw new LissomError('transfer-no-pose', t('error.transfer-no-pose'));
    await this.#ask(pose.id, null);
  }

  /** Asks for another model in the place of the open step's. */
  async change(): Promise<void> {
    const { recipe, selection } = this.parts.document;
    const step = edit.stepOf(recipe, selection.step, 'transfer');
    if (step) await this.#ask(step.like, step.id);
  }

  cancel(): void {
    this.parts.state.choice.value = null;
  }

  /** @param swaps  id of the step that gets another model; `null`: a new step begins */
  async #ask(like: string, swaps: string | null): Promise<void> {
    const { state, document } = this.parts;
    const { recipe } = document;
    const source = await this.follow.source(recipe, { like });
    if (document.recipe !== recipe) return;
    this.own.source.value = source;
    const choose = (name: string, ref: ModelRef) => this.#choose(name, ref, like, swaps);
    state.choice.value = { recipe, workspace: 'transfer', drop: 'ui.drop.target', choose };
  }

  #choose(name: string, ref: ModelRef, like: string, swaps: string | null): void {
    const { state, document } = this.parts;
    if (!state.choosing.peek()) return;
    const { recipe: before, name: model } = edit.withModel(document.recipe, name, ref);
    const swapped = edit.stepOf(before, swaps ?? '', 'transfer');
    const id = swapped?.id ?? edit.freeId('transfer', before);
    const bare = newTransferStep(id, model, like, poseOf(before, { like })?.handles.length ?? 0);
    const recipe = swapped
      ? edit.pruneModels(
          edit.replaceStep(before, { ...bare, strength: swapped.strength, keepStretch: swapped.keepStretch }),
        )
      : edit.addStep(before, bare);
    this.own.atRest.value = false;
    document.commit(t('history.transfer.start', { name: model }), recipe, { step: id, item: 0 });
    state.choice.value = null;
    state.tool.value = 'paint-pair';
  }
}
