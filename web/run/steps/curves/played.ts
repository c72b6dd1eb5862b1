// A step's poses as they are played: when each is reached, and what lies between two of them.

import type { Curve, CurvePosture, CurvesStep } from '../../../recipe/steps/curves';

export type Pose = CurvesStep['poses'][number];

/** Seconds from a pose to the next one that has no time of its own. */
const STEP = 1;

/** A pose with the time at which it is reached. */
export interface TimedPose {
  readonly time: number;
  readonly pose: Pose;
}

/** Poses in the order in which they are played; of several at one time the last. */
export function timedPoses(poses: readonly Pose[]): TimedPose[] {
  const byTime = new Map<number, Pose>();
  let next = 0;
  for (const pose of poses) {
    const time = pose.time ?? next;
    byTime.set(time, pose);
    next = time + STEP;
  }
  return [...byTime].map(([time, pose]) => ({ time, pose })).sort((a, b) => a.time - b.time);
}

/** The posture of each curve in a pose; of those that it does not name the one at rest. */
export function posturesIn(pose: Pose, curves: readonly Pick<Curve, 'id'>[]): CurvePosture[] {
  const named = new Map(pose.curves.map((posture) => [posture.id, posture]));
  return curves.map(({ id }) => named.get(id) ?? {});
}

/** What lies between two postures of a curve. @param share  0 is the first, 1 the second */
export function postureBetween(
  rest: Curve['rest'],
  from: CurvePosture,
  to: CurvePosture,
  share: number,
): CurvePosture {
  if (share <= 0) return from;
  if (share >= 1) return to;
  const mix = (a: number, b: number) => a + share * (b - a);
  const posed = (at: CurvePosture) => at.posed ?? rest;
  const twist = (at: CurvePosture) => at.twist ?? rest.map(() => 0);
  const scale = (at: CurvePosture) => at.scale ?? rest.map((): [number, number] => [1, 1]);
  const factor = (a: number, b: number) => a ** (1 - share) * b ** share;
  return {
    posed: posed(from).map((p, k) => {
      const q = posed(to)[k]!;
      return [mix(p[0], q[0]), mix(p[1], q[1]), mix(p[2], q[2])];
    }),
    base: slerp(from.base ?? UNTURNED, to.base ?? UNTURNED, share),
    twist: twist(from).map((angle, k) => mix(angle, twist(to)[k]!)),
    scale: scale(from).map(([a, b], k) => {
      const [c, d] = scale(to)[k]!;
      return [factor(a, c), factor(b, d)];
    }),
  };
}

type Quaternion = NonNullable<CurvePosture['base']>;
const UNTURNED: Quaternion = [0, 0, 0, 1];

/** Along the shorter way (Shoemake 1985). */
function slerp(from: Quaternion, to: Quaternion, share: number): Quaternion {
  const [a, b] = [unit(from), unit(to)];
  const dot = a.reduce((sum, x, k) => sum + x * b[k]!, 0);
  const angle = Math.acos(Math.min(1, Math.abs(dot)));
  const sine = Math.sin(angle);
  const [p, q] =
    sine < 1e-9 ? [1 - share, share] : [Math.sin((1 - share) * angle) / sine, Math.sin(share * angle) / sine];
  const sided = dot < 0 ? -q : q;
  return unit(a.map((x, k) => p * x + sided * b[k]!) as Quaternion);
}

function unit(q: Quaternion): Quaternion {
  const length = Math.hypot(...q);
  return q.map((x) => x / length) as Quaternion;
}
