// A step's poses as they are played, thick enough for programs that go in straight lines from one to the next.

import type { Curve, CurvesStep } from '../../../recipe/steps/curves';
import { beginnings, betweenPoses } from '../../../recipe/steps/curves-poses';

/** Poses a second: joints go in straight lines, limbs do not. */
const RATE = 12;

/** The curves at each time, the poses themselves among them. It ends with the last: whether to begin again is the player's to say. */
export function* played(
  step: CurvesStep,
): Iterable<{ readonly time: number; readonly curves: readonly Curve[] }> {
  const times = beginnings(step.poses);
  for (const [at, pose] of step.poses.entries()) {
    const next = step.poses[at + 1];
    const length = times[at + 1]! - times[at]!;
    const count = next ? Math.max(1, Math.ceil(length * RATE)) : 1;
    for (let k = 0; k < count; k++) {
      const { curves } = betweenPoses(step, pose, next ?? pose, k / count);
      yield { time: times[at]! + (k / count) * length, curves };
    }
  }
}
