// Edits of the open merge step that panels and commands ask for; each is one step of undo.

import { LissomError } from '../../core/errors';
import { fromIndices } from '../../core/vertex-set';
import type { RegionMaps } from '../../kernel/contract/merge';
import type { MergeStep, ModelRef } from '../../recipe/recipe';
import type { Runner } from '../../run/evaluate';
import type { Mark } from '../../tools/merge/host';
import type { Loop } from '../../tools/merge/loops';
import {
  type MergeSide,
  otherSide,
  type Pin,
  pinsOf,
  removeKey,
  withFoundKeys,
} from '../../tools/merge/pins';
import type { MergeService } from '../api';
import { t } from '../i18n';
import { Aids } from './aids';
import type { EditParts } from './edits';
import { type Meeting, meetingOf } from './meeting';
import { PartChoice } from './part-choice';
import { MergeShape } from './shape';
import {
  isReady,
  MARKS,
  markOf,
  type OptimalBoundary,
  sideOfMark,
  withBoundaries,
  withMark,
  withMergeStep,
} from './steps';

interface Parts extends EditParts {
  readonly runner: Pick<Runner, 'opened' | 'ask'>;
}

export class MergeActions extends MergeShape implements MergeService {
  readonly aids: Aids;
  readonly #part: PartChoice;
  constructor(protected override readonly parts: Parts) {
    super(parts);
    this.aids = new Aids(parts.state.merge.sides);
    this.#part = new PartChoice(parts);
  }

  start(target: string): Promise<void> {
    return this.#part.ask(target, null);
  }

  async changePart(): Promise<void> {
    const step = this.step;
    if (step) await this.#part.ask(step.target, step.id);
  }

  cancelChoosing(): Promise<void> {
    return this.#part.cancel();
  }

  choosePart(name: string, ref: ModelRef): void {
    this.#part.choose(name, ref);
  }

  setMark(mark: Mark, vertices: Uint32Array, label: string): void {
    const { state } = this.parts;
    const step = this.step;
    const count = this.#count(sideOfMark(mark));
    if (!step || count === 0) return;
    // Rough marks come in several strokes: they are merged when the button says so.
    if (step.boundaries.length > 0 || !isReady(step)) state.merge.held.value = step.id;
    this.commit(label, withMark(step, mark, fromIndices(vertices, count) as OptimalBoundary['feature']));
  }

  clearMark(mark: Mark): void {
    this.setMark(mark, new Uint32Array(), t('history.merge.clear-mark'));
  }

  markSize(mark: Mark): number {
    const step = this.parts.state.mergeStep.value;
    const side = this.parts.state.merge.sides.value[sideOfMark(mark)];
    return step && side ? markOf(step, mark, side.model.positions.length / 3).length : 0;
  }

  async merge(): Promise<void> {
    const { state } = this.parts;
    const step = this.step;
    if (!step) return;
    if (step.boundaries.length === 0) {
      const found = await this.#meeting(step, false);
      if (this.step !== step) return;
      this.#apply(step, found);
    }
    state.merge.problem.value = null;
    state.merge.held.value = null;
  }

  async cutAlongMarks(): Promise<void> {
    const step = this.step;
    if (!step) return;
    const found = await this.#meeting(step, true);
    if (this.step !== step) return;
    this.#apply(step, found);
    this.parts.state.merge.held.value = null;
  }

  pickLoop(side: MergeSide, loop: Loop): void {
    const { picked, held } = this.parts.state.merge;
    const step = this.step;
    const other = picked.peek();
    if (!step) return;
    if (!other || other.side === side) {
      picked.value = other?.loop === loop ? null : { side, loop };
      return;
    }
    const pair = { [side]: [...loop], [otherSide(side)]: [...other.loop] } as Record<MergeSide, number[]>;
    const boundary = { ...pair, keys: [], sourceKeep: [], targetKeep: [] };
    picked.value = null;
    held.value = null;
    const boundaries = [...withFoundKeys(step.boundaries, this.#foundKeys), boundary];
    this.commit(t('history.merge.pair'), withBoundaries(step, boundaries));
  }

  removePair(index: number): void {
    const step = this.step;
    if (!step) return;
    const { transition: _, ...bare } = step;
    const boundaries = step.boundaries.filter((_, i) => i !== index);
    this.commit(
      t('history.merge.remove-pair'),
      boundaries.length > 0 ? { ...step, boundaries } : { ...bare, boundaries },
    );
  }

  pins(): readonly Pin[] {
    const step = this.parts.state.mergeStep.value;
    return step ? pinsOf(step.boundaries, this.#foundKeys) : [];
  }

  /** The step's boundaries, the keys that were found written into them. */
  boundaries(): MergeStep['boundaries'] {
    return withFoundKeys(this.step?.boundaries ?? [], this.#foundKeys);
  }

  removePin(number: number): void {
    const pin = this.pins()[number];
    if (!pin) return;
    const boundaries = this.boundaries().map((boundary, i) =>
      i === pin.boundary ? removeKey(boundary, pin.key) : boundary,
    );
    this.setBoundaries(t('history.merge.remove-pin'), boundaries, null);
  }

  setBoundaries(label: string, boundaries: MergeStep['boundaries'], pin: number | null): void {
    const step = this.step;
    if (!step) return;
    this.parts.state.merge.held.value = null;
    this.commit(label, { ...step, boundaries }, pin);
  }

  previewBoundaries(boundaries: MergeStep['boundaries'], pin: number | null): void {
    const { document } = this.parts;
    const step = this.step;
    if (!step) return;
    document.preview(withMergeStep(document.recipe, { ...step, boundaries }), {
      step: step.id,
      handle: pin,
    });
  }

  setPlacement(placement: OptimalBoundary['placement']): void {
    const step = this.step;
    if (!step?.optimalBoundary) return;
    const { placement: _, ...marks } = step.optimalBoundary;
    const optimalBoundary = placement ? { ...marks, placement } : marks;
    this.commit(t('history.merge.placement'), { ...step, optimalBoundary });
  }

  async maps(): Promise<RegionMaps | null> {
    const step = this.step;
    if (!step?.optimalBoundary || !isReady(step)) return null;
    try {
      return await this.parts.runner.ask(this.parts.document.recipe, step.id, 'maps', {});
    } catch (error) {
      // What is wrong with the marks is told where they are merged.
      if (error instanceof LissomError) return null;
      throw error;
    }
  }

  /** Those that lie on the loops as they are now: the last merge may have been of others. */
  get #foundKeys() {
    const boundaries = this.parts.state.mergeStep.value?.boundaries ?? [];
    const found = this.parts.state.merge.figures.value?.keys ?? [];
    return boundaries.map(({ source, target }, i) =>
      (found[i] ?? []).filter(([s, t]) => source.includes(s) && target.includes(t)),
    );
  }

  #count(side: MergeSide): number {
    return (this.parts.state.merge.sides.peek()[side]?.model.positions.length ?? 0) / 3;
  }

  /** @throws LissomError  where the marks say too little, in words that say what to do */
  #meeting(step: MergeStep, cut: boolean): Promise<Meeting> {
    const { document, runner } = this.parts;
    const { recipe } = document;
    const part = (side: MergeSide) => {
      const aid = this.aids.of(side);
      if (!aid) throw new LissomError('merge-no-model', t('error.merge-no-model'));
      const marks = Object.fromEntries(
        MARKS.filter((mark) => sideOfMark(mark) === side).map((mark) => [
          mark,
          markOf(step, mark, aid.positions.length / 3),
        ]),
      ) as Partial<Record<Mark, Uint32Array>>;
      const loopsAround = (vertices: Uint32Array) =>
        runner.ask(recipe, step.id, 'loopsAround', { side, vertices });
      return { ...aid, marks, loopsAround };
    };
    return meetingOf(part('source'), part('target'), cut);
  }

  #apply(step: MergeStep, found: Meeting): void {
    if (found.kind === 'loops') {
      this.parts.state.tool.value = 'merge-pins';
      this.commit(t('history.merge.find'), withBoundaries(step, [...found.boundaries]));
      return;
    }
    const next = MARKS.reduce((marked, mark) => {
      const count = this.#count(sideOfMark(mark));
      const known = markOf(step, mark, count);
      const vertices = found.marks[mark];
      const isSame = known.length === vertices.length && known.every((v, i) => v === vertices[i]);
      return isSame
        ? marked
        : withMark(marked, mark, fromIndices(vertices, count) as OptimalBoundary['feature']);
    }, step);
    if (next !== step) this.commit(t('history.merge.find'), next);
  }
}
