// Loops that are joined, and the pins that say which of their points meet.

import type { MergeStep } from '../../recipe/recipe';
import type { Loop } from '../../tools/merge/loops';
import {
  type MergeSide,
  otherSide,
  type Pin,
  pinsOf,
  removeKey,
  withFoundKeys,
} from '../../tools/merge/pins';
import { t } from '../i18n';
import type { MergeEdits } from './edits';
import type { MergeState } from './state';
import { withBoundaries } from './steps';

export class Joins {
  constructor(
    private readonly edits: MergeEdits,
    private readonly own: MergeState,
  ) {}

  pickLoop(side: MergeSide, loop: Loop): void {
    const { picked } = this.own;
    const { step } = this.edits;
    const other = picked.peek();
    if (!step) return;
    if (!other || other.side === side) {
      picked.value = other?.loop === loop ? null : { side, loop };
      return;
    }
    const pair = { [side]: [...loop], [otherSide(side)]: [...other.loop] } as Record<MergeSide, number[]>;
    const boundary = { ...pair, keys: [], sourceKeep: [], targetKeep: [] };
    picked.value = null;
    this.own.letGo();
    const boundaries = [...withFoundKeys(step.boundaries, this.#foundKeys), boundary];
    this.edits.commit(t('history.merge.pair'), withBoundaries(step, boundaries));
  }

  removePair(index: number): void {
    const { step } = this.edits;
    if (!step) return;
    const { transition: _, ...bare } = step;
    const boundaries = step.boundaries.filter((_, i) => i !== index);
    this.edits.commit(
      t('history.merge.remove-pair'),
      boundaries.length > 0 ? { ...step, boundaries } : { ...bare, boundaries },
    );
  }

  /** As shown: the step's own, or those the last merge found. */
  pins(): readonly Pin[] {
    const step = this.own.step.value;
    return step ? pinsOf(step.boundaries, this.#foundKeys) : [];
  }

  /** The step's boundaries, the keys that were found written into them. */
  boundaries(): MergeStep['boundaries'] {
    return withFoundKeys(this.edits.step?.boundaries ?? [], this.#foundKeys);
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
    const { step } = this.edits;
    if (!step) return;
    this.own.letGo();
    this.edits.commit(label, { ...step, boundaries }, pin);
  }

  previewBoundaries(boundaries: MergeStep['boundaries'], pin: number | null): void {
    const { step } = this.edits;
    if (step) this.edits.preview({ ...step, boundaries }, pin);
  }

  /** Those that lie on the loops as they are now: the last merge may have been of others. */
  get #foundKeys() {
    const boundaries = this.own.step.value?.boundaries ?? [];
    const found = this.own.figures.value?.keys ?? [];
    return boundaries.map(({ source, target }, i) =>
      (found[i] ?? []).filter(([s, t]) => source.includes(s) && target.includes(t)),
    );
  }
}
