// What panels and commands ask of the open dress step; each edit is one step of undo, except previews.

import * as edit from '../../recipe/edit';
import type { DressStep, MatchStep } from '../../recipe/recipe';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import { DressEdits } from './edits';
import { GarmentChoice } from './garment-choice';
import type { DressState } from './state';

export class DressActions {
  readonly edits: DressEdits;
  readonly choice: GarmentChoice;

  constructor(
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'runner'>,
    private readonly own: DressState,
  ) {
    this.edits = new DressEdits(parts.document);
    this.choice = new GarmentChoice(parts, own);
  }

  /** All that is worn in the document. Reads signals. */
  garments(): readonly DressStep[] {
    return edit.stepsOf(this.parts.state.recipe.value, 'dress');
  }

  /** Reads signals. */
  matches(): readonly MatchStep[] {
    return edit.stepsOf(this.parts.state.recipe.value, 'match');
  }

  /** Names of the bodies, in their order. Reads signals. */
  bodies(): readonly string[] {
    const step = this.own.step.value;
    return (step && edit.stepOf(this.parts.state.recipe.value, step.match, 'match')?.models) ?? [];
  }

  chooseMatch(id: string): void {
    const { step } = this.edits;
    const match = edit.stepOf(this.parts.document.recipe, id, 'match');
    if (!step || !match || step.match === id) return;
    const from = match.models.includes(step.from) ? step.from : match.models[0]!;
    const to = match.models.find((name) => name !== from)!;
    this.edits.commit(t('history.dress.match'), { ...step, match: id, from, to });
  }

  /** Who it was made for; the body that it is put on gives way. */
  setFrom(from: string): void {
    const { step } = this.edits;
    if (!step || step.from === from) return;
    const to = step.to === from ? step.from : step.to;
    this.edits.commit(t('history.dress.from', { name: from }), { ...step, from, to });
  }

  setTo(to: string): void {
    const { step } = this.edits;
    if (!step || step.to === to) return;
    this.edits.commit(t('history.dress.to', { name: to }), { ...step, to });
  }

  setOffset(offset: number, live = false): void {
    const { step } = this.edits;
    if (!step) return;
    const label = t('history.dress.offset');
    const next = { ...step, offset: Number(offset.toPrecision(4)) };
    if (live) this.edits.preview(label, next);
    else this.edits.commit(label, next);
  }

  /** The same garment on the next of the bodies that does not wear it yet, in a step of its own. */
  another(): void {
    const { document } = this.parts;
    const { step } = this.edits;
    if (!step) return;
    const to = this.#free(step);
    const id = edit.freeId('dress', document.recipe);
    const recipe = edit.addStep(document.recipe, { ...step, id, to: to ?? step.to });
    document.commit(t('history.dress.another', { name: to ?? step.to }), recipe, { step: id, item: null });
  }

  /** Reads signals. */
  get canFitAnother(): boolean {
    const step = this.own.step.value;
    return step !== undefined && this.#free(step) !== undefined;
  }

  #free({ garment, match, from }: DressStep): string | undefined {
    const worn = new Set(
      this.garments().flatMap((each) => (each.garment === garment && each.match === match ? each.to : [])),
    );
    return this.bodies().find((name) => name !== from && !worn.has(name));
  }
}
