// Rough marks on the two models, and finding where they meet from them.

import { LissomError } from '../../core/errors';
import { fromIndices } from '../../core/vertex-set';
import type { MergeStep } from '../../recipe/recipe';
import type { Mark } from '../../tools/merge/host';
import type { MergeSide } from '../../tools/merge/pins';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { Aids } from './aids';
import type { MergeEdits } from './edits';
import { type Meeting, meetingOf } from './meeting';
import type { MergeState } from './state';
import { isReady, MARKS, markOf, sideOfMark, withBoundaries, withMark } from './steps';

export class Marking {
  constructor(
    private readonly edits: MergeEdits,
    private readonly own: MergeState,
    private readonly aids: Aids,
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'runner'>,
  ) {}

  setMark(mark: Mark, vertices: Uint32Array, label: string): void {
    const { step } = this.edits;
    const count = this.#count(sideOfMark(mark));
    if (!step || count === 0) return;
    // Rough marks come in several strokes: they are merged when the button says so.
    if (step.boundaries.length > 0 || !isReady(step)) this.own.hold(step.id);
    this.edits.commit(label, withMark(step, mark, fromIndices(vertices, count)));
  }

  clearMark(mark: Mark): void {
    this.setMark(mark, new Uint32Array(), t('history.merge.clear-mark'));
  }

  /** How many vertices are marked. */
  markSize(mark: Mark): number {
    const step = this.own.step.value;
    const side = this.own.sides.value[sideOfMark(mark)];
    return step && side ? markOf(step, mark, side.model.positions.length / 3).length : 0;
  }

  /** Finds where the models meet, as far as that is not said yet, and merges them. */
  async merge(): Promise<void> {
    const { step } = this.edits;
    if (!step) return;
    if (step.boundaries.length === 0) {
      const found = await this.#meeting(step, false);
      if (this.edits.step !== step) return;
      this.#apply(step, found);
    }
    this.own.problem.value = null;
    this.own.letGo();
  }

  /** Joins the models along the edges of the marks instead of a line that is sought. */
  async cutAlongMarks(): Promise<void> {
    const { step } = this.edits;
    if (!step) return;
    const found = await this.#meeting(step, true);
    if (this.edits.step !== step) return;
    this.#apply(step, found);
    this.own.letGo();
  }

  #count(side: MergeSide): number {
    return (this.own.sides.peek()[side]?.model.positions.length ?? 0) / 3;
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
    const { state } = this.parts;
    if (found.kind === 'loops') {
      state.tool.value = 'merge-pins';
      this.edits.commit(t('history.merge.find'), withBoundaries(step, [...found.boundaries]));
      return;
    }
    const next = MARKS.reduce((marked, mark) => {
      const count = this.#count(sideOfMark(mark));
      const known = markOf(step, mark, count);
      const vertices = found.marks[mark];
      const isSame = known.length === vertices.length && known.every((v, i) => v === vertices[i]);
      return isSame ? marked : withMark(marked, mark, fromIndices(vertices, count));
    }, step);
    if (next !== step) this.edits.commit(t('history.merge.find'), next);
  }
}
