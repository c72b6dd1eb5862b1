// How the open merge step merges: fitted or in place, how smooth, how far the models overlap.

import type { Model } from '../../core/model';
import { fromIndices, toIndices } from '../../core/vertex-set';
import type { MergeStep } from '../../recipe/recipe';
import { centroid, compose, decompose, IDENTITY, subtract } from '../../tools/geometry';
import { arcLengths, distancesTo } from '../../tools/merge/loops';
import type { MergeSide } from '../../tools/merge/pins';
import type { Vec3 } from '../../view/types';
import { t } from '../i18n';
import type { Pose } from '../pose';
import type { MergeEdits } from './edits';
import type { MergeState } from './state';

/** Width of a transition when it is switched on, as a part of the loop's length. */
const STRIP = 0.08;
/** How far a part merged in place gives way, likewise. */
const REACH = 0.3;

export class MergeShape {
  constructor(
    private readonly edits: MergeEdits,
    private readonly own: Pick<MergeState, 'step' | 'sides'>,
  ) {}

  /** In place, what lies beyond a strip along the loops is held where it is; fitted, nothing is. */
  setMode(mode: MergeStep['mode']): void {
    const { step } = this.edits;
    if (!step || step.mode === mode) return;
    const { pose, ...bare } = step;
    if (mode === 'independent') this.edits.commit(t('history.merge.mode'), { ...bare, mode, roi: 'all' });
    else {
      const placed = { pose: pose ?? this.#onTarget(step), roi: this.#strip(step, REACH) };
      this.edits.commit(t('history.merge.mode'), { ...bare, mode, ...placed });
    }
  }

  /** How far from the seam a part merged in place gives way, as a part of the loops' length. */
  setReach(share: number, live = false): void {
    const { step } = this.edits;
    if (step)
      this.edits.set(t('history.merge.reach'), { ...step, roi: this.#strip(step, share) }, live, 'reach');
  }

  reach(): number {
    const step = this.own.step.value;
    const positions = this.#positions;
    if (!step || !positions) return REACH;
    const off = distancesTo(
      positions,
      step.boundaries.flatMap(({ source }) => source),
    );
    const most = toIndices(step.roi, off.length).reduce((far, v) => Math.max(far, off[v]!), 0);
    return most / this.#loopLength(step, 'source');
  }

  /** Where the part stands in the target's space, for merging in place; about its middle. */
  pose(): Pose {
    return decompose(this.own.step.value?.pose ?? IDENTITY, this.#middle);
  }

  setPose(change: Partial<Pose>, live = false): void {
    const { step } = this.edits;
    if (!step || !(Object.values(change).flat() as number[]).every(Number.isFinite)) return;
    const pose = [...compose({ ...this.pose(), ...change }, this.#middle)];
    this.edits.set(t('history.merge.pose'), { ...step, pose }, live, 'pose');
  }

  setSmoothing(smoothing: number, live = false): void {
    const { step } = this.edits;
    if (step) this.edits.set(t('history.merge.smoothing'), { ...step, smoothing }, live, 'smoothing');
  }

  /** Widths of the overlapped strips as parts of the loops' lengths; `null`: none. */
  setTransition(shares: Readonly<Record<MergeSide, number>> | null, live = false): void {
    const { step } = this.edits;
    if (!step) return;
    const { transition: old, ...bare } = step;
    if (!shares) {
      this.edits.set(t('history.merge.transition-off'), bare, live, 'transition');
      return;
    }
    const width = (side: MergeSide) => Number((shares[side] * this.#loopLength(step, side)).toPrecision(4));
    const transition = {
      sourceWidth: width('source'),
      targetWidth: width('target'),
      weight: old?.weight ?? 0.1,
    };
    this.edits.set(t('history.merge.transition'), { ...bare, transition }, live, 'transition');
  }

  /** Widths as parts of the loops' lengths; `STRIP` where there is no transition. */
  transitionShares(): Readonly<Record<MergeSide, number>> {
    const step = this.own.step.value;
    if (!step?.transition) return { source: STRIP, target: STRIP };
    const { sourceWidth, targetWidth } = step.transition;
    return {
      source: sourceWidth / this.#loopLength(step, 'source'),
      target: targetWidth / this.#loopLength(step, 'target'),
    };
  }

  get #positions(): Float64Array | undefined {
    return this.own.sides.value.source?.model.positions;
  }

  /** The part as large as the target's loops ask for, its loops around theirs: where one starts to place it. */
  #onTarget(step: MergeStep): number[] {
    const { source, target } = this.own.sides.peek();
    if (!source || !target) return [...IDENTITY];
    const middleOf = (side: MergeSide, { positions }: Model): Vec3 =>
      centroid(
        positions,
        step.boundaries.flatMap((boundary) => boundary[side]),
      );
    const [from, to] = [middleOf('source', source.model), middleOf('target', target.model)];
    const size = this.#loopLength(step, 'target') / this.#loopLength(step, 'source');
    const still = { translation: [0, 0, 0], rotation: [0, 0, 0] } as const;
    const translation = subtract(to, from);
    return [...compose({ ...still, translation, scale: [size, size, size] }, from)];
  }

  /** The part's vertices no farther from its loops than a share of their length. */
  #strip(step: MergeStep, share: number): MergeStep['roi'] {
    const positions = this.#positions;
    if (!positions) return 'all';
    const off = distancesTo(
      positions,
      step.boundaries.flatMap(({ source }) => source),
    );
    const limit = share * this.#loopLength(step, 'source');
    const near = Uint32Array.from(off.keys()).filter((v) => off[v]! <= limit);
    return fromIndices(near, off.length);
  }

  /** Of the part. */
  get #middle(): Vec3 {
    const positions = this.#positions;
    if (!positions) return [0, 0, 0];
    return centroid(positions, new Uint32Array(positions.length / 3).keys());
  }

  #loopLength(step: MergeStep, side: MergeSide): number {
    const model = this.own.sides.peek()[side]?.model;
    const lengths = step.boundaries.map((boundary) =>
      model ? arcLengths(boundary[side], model.positions).at(-1)! : 1,
    );
    return Math.max(...lengths, 0) || 1;
  }
}
