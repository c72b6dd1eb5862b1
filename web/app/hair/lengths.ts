// Painted lengths as colours on the head, while they are painted.

import { lengthFactors } from '../../run/steps/hair';
import type { Evaluation } from '../evaluated';
import type { State } from '../state';
import type { HairState } from './state';

/** Factors at the two ends of the colours; what is not painted has the colour in the middle. */
export const LENGTHS: readonly [number, number] = [0, 2];

/** Hair that hides the colours no more than it must: so many strands are drawn. */
export const SPARSE = 1200;

/** Reads signals. @returns a factor per vertex of the model on screen, `null` while lengths are not painted */
export function shownLengths(
  state: Pick<State, 'tool'>,
  own: Pick<HairState, 'step'>,
  shown: Evaluation | null,
): Float32Array | null {
  const step = own.step.value;
  if (state.tool.value !== 'paint-length' || !step || shown?.step.id !== step.id) return null;
  return lengthFactors(step.length.map, shown.shown.model.positions.length / 3);
}
