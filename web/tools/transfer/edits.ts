// Pure edits of a transfer step's counterparts. A vertex belongs to one of them at most.

import { fromIndices, holds, isEmpty, toIndices } from '../../core/vertex-set';
import type { DeformHandle, TransferStep } from '../../recipe/recipe';

/** The step whose counterpart of handle `index` is exactly `vertices`, of the model's `count`; they leave the others. */
export function setCounterpart(
  step: TransferStep,
  index: number,
  vertices: Uint32Array,
  count: number,
): TransferStep {
  const own = new Set(vertices);
  const handles = step.handles.map((set, i) => {
    if (i === index) return fromIndices(own, count);
    const held = toIndices(set, count);
    const kept = held.filter((v) => !own.has(v));
    return kept.length === held.length ? set : fromIndices(kept, count);
  });
  return { ...step, handles };
}

/** Number of the counterpart that holds a vertex; −1 if none does. */
export const counterpartAt = ({ handles }: Pick<TransferStep, 'handles'>, vertex: number): number =>
  handles.findIndex((set) => holds(set, vertex));

/** Numbers of the handles that both models have, and of those that only the pose has. */
export function pairing(
  step: Pick<TransferStep, 'handles'>,
  handles: readonly Pick<DeformHandle, 'vertices'>[],
): { readonly paired: readonly number[]; readonly open: readonly number[] } {
  const numbers = handles.map((_, i) => i);
  const isPaired = (i: number) => !isEmpty(handles[i]!.vertices) && !isEmpty(step.handles[i] ?? []);
  return { paired: numbers.filter(isPaired), open: numbers.filter((i) => !isPaired(i)) };
}

/** The next handle without a counterpart after one, around the end; `null` where every one has its own. */
export function nextOpen(open: readonly number[], after: number | null): number | null {
  return open.find((i) => i > (after ?? -1)) ?? open[0] ?? null;
}
