// Choosing what is to be worn. Until it is chosen nothing has happened to the recipe.

import { LissomError } from '../../core/errors';
import * as edit from '../../recipe/edit';
import type { MatchStep, ModelRef } from '../../recipe/recipe';
import { newDressStep } from '../../recipe/steps/dress';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { DressState } from './state';

export class GarmentChoice {
  constructor(
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'runner'>,
    private readonly own: Pick<DressState, 'source'>,
  ) {}

  /** Whether there are bodies to be dressed. */
  get canStart(): boolean {
    return this.#match() !== undefined;
  }

  /** @throws LissomError `dress-no-match` where no models are matched */
  async start(): Promise<void> {
    const match = this.#match();
    if (!match) throw new LissomError('dress-no-match', t('error.dress-no-match'));
    await this.#ask(match, null);
  }

  /** Asks for another garment in the place of the open step's. */
  async change(): Promise<void> {
    const { recipe, selection } = this.parts.document;
    const step = edit.stepOf(recipe, selection.step, 'dress');
    const match = step && edit.stepOf(recipe, step.match, 'match');
    if (step && match) await this.#ask(match, step.id);
  }

  cancel(): void {
    this.parts.state.choice.value = null;
  }

  /** Of the open step, else the open one, else the last. */
  #match(): MatchStep | undefined {
    const { recipe, selection } = this.parts.document;
    const open = edit.stepOf(recipe, selection.step, 'dress')?.match ?? selection.step;
    const matches = edit.stepsOf(recipe, 'match');
    return matches.find(({ id }) => id === open) ?? matches.at(-1);
  }

  /** @param swaps  id of the step that gets another garment; `null`: a new step begins */
  async #ask(match: MatchStep, swaps: string | null): Promise<void> {
    const { state, document, runner } = this.parts;
    const { recipe } = document;
    const from = edit.stepOf(recipe, swaps ?? document.selection.step, 'dress')?.from ?? match.models[0]!;
    const body = await runner.opened(recipe, from);
    if (document.recipe !== recipe) return;
    this.own.source.value = body;
    const choose = (name: string, ref: ModelRef) => this.#choose(name, ref, match, swaps);
    state.choice.value = { recipe, workspace: 'dress', drop: 'ui.drop.garment', choose };
  }

  #choose(name: string, ref: ModelRef, match: MatchStep, swaps: string | null): void {
    const { state, document } = this.parts;
    if (!state.choosing.peek()) return;
    const { recipe: before, name: garment } = edit.withModel(document.recipe, name, ref);
    const swapped = edit.stepOf(before, swaps ?? '', 'dress');
    const like = swapped ?? edit.stepOf(before, document.selection.step, 'dress');
    const id = swapped?.id ?? edit.freeId('dress', before);
    const [from, to] = like ? [like.from, like.to] : (match.models as [string, string]);
    const bare = newDressStep(id, garment, match.id, from, to);
    const recipe = swapped
      ? edit.pruneModels(edit.replaceStep(before, { ...bare, offset: swapped.offset }))
      : edit.addStep(before, bare);
    document.commit(t('history.dress.start', { name: garment }), recipe, { step: id, item: null });
    state.choice.value = null;
  }
}
