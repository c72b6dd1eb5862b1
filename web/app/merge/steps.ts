// What a merge step says: its marks, and whether it can be run yet.

import { isEmpty, toIndices } from '../../core/vertex-set';
import type { MergeStep } from '../../recipe/recipe';
import type { Mark } from '../../tools/merge/host';
import type { MergeSide } from '../../tools/merge/pins';

export type OptimalBoundary = NonNullable<MergeStep['optimalBoundary']>;

export const NO_MARKS: OptimalBoundary = { sourceRegion: [], feature: [], targetRegion: [] };

const FIELDS = { source: 'sourceRegion', feature: 'feature', target: 'targetRegion' } as const;
export const MARKS = ['source', 'feature', 'target'] as const satisfies readonly Mark[];

/** The model that a mark is painted on. */
export const sideOfMark = (mark: Mark): MergeSide => (mark === 'target' ? 'target' : 'source');

export const markOf = (step: Pick<MergeStep, 'optimalBoundary'>, mark: Mark, count: number): Uint32Array =>
  toIndices(step.optimalBoundary?.[FIELDS[mark]] ?? [], count);

/** The step with one mark painted anew; whatever was found or placed for the old ones goes. */
export function withMark(step: MergeStep, mark: Mark, vertices: OptimalBoundary['feature']): MergeStep {
  const { transition: _, ...bare } = step;
  const { placement: __, ...marks } = step.optimalBoundary ?? NO_MARKS;
  const optimalBoundary = { ...marks, [FIELDS[mark]]: vertices };
  return { ...bare, mode: 'independent', roi: 'all', boundaries: [], optimalBoundary };
}

/** The step with loops to join instead of marks. */
export function withBoundaries(step: MergeStep, boundaries: MergeStep['boundaries']): MergeStep {
  const { optimalBoundary: _, ...bare } = step;
  return { ...bare, boundaries };
}

/** Whether the step says where to join the models. */
export function isReady({ boundaries, optimalBoundary: marks }: MergeStep): boolean {
  if (boundaries.length > 0) return true;
  return marks !== undefined && MARKS.every((mark) => !isEmpty(marks[FIELDS[mark]]));
}

/** Whether both are of one factored session: only keys differ. */
export const sameCut = (a: MergeStep, b: MergeStep): boolean =>
  a.id === b.id &&
  a.source === b.source &&
  a.target === b.target &&
  a.mode === b.mode &&
  a.optimalBoundary === b.optimalBoundary &&
  a.transition === b.transition &&
  a.roi === b.roi &&
  a.handles === b.handles &&
  a.pose === b.pose &&
  a.smoothing === b.smoothing &&
  a.boundaries.length === b.boundaries.length &&
  a.boundaries.every(
    (boundary, i) =>
      boundary.source === b.boundaries[i]!.source && boundary.target === b.boundaries[i]!.target,
  );
