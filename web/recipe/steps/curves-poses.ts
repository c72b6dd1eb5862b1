// Poses that a curves step keeps, and what lies between two of them.

import { freeName } from '../names';
import type { Curve, CurvePosture, CurvesStep } from './curves';
import { type CurvePose, curveById, isPosed, postureOf, updateCurve } from './curves-edits';

type Point = Curve['rest'][number];
type Quaternion = NonNullable<CurvePosture['base']>;

/** The step's curves as they are now, under a name. */
export const poseOf = ({ curves }: CurvesStep, name: string): CurvePose => ({
  name,
  curves: curves.filter(isPosed).map((curve) => ({ id: curve.id, ...postureOf(curve) })),
});

export const addPose = (step: CurvesStep, name: string): CurvesStep => ({
  ...step,
  poses: [...step.poses, poseOf(step, name)],
});

export const removePose = (step: CurvesStep, at: number): CurvesStep => ({
  ...step,
  poses: step.poses.filter((_, k) => k !== at),
});

export const renamePose = (step: CurvesStep, at: number, name: string): CurvesStep => ({
  ...step,
  poses: step.poses.map((pose, k) => (k === at ? { ...pose, name } : pose)),
});

/** The step with its curves as a pose has them; those that it does not name are at rest. */
export const takePose = (step: CurvesStep, pose: CurvePose): CurvesStep =>
  step.curves.reduce((held, { id }) => {
    const { posed, base, twist, scale } = pose.curves.find((each) => each.id === id) ?? ({} as CurvePosture);
    return updateCurve(held, id, { posed, base, twist, scale });
  }, step);

/**
 * What lies between two poses: at 0 the first, at 1 the second. Segments turn from one direction into the other at an even
 * pace, and so keep their length where both poses have the same: a limb that swings does not shrink on the way.
 */
export function betweenPoses(step: CurvesStep, from: CurvePose, to: CurvePose, t: number): CurvesStep {
  if (t <= 0) return takePose(step, from);
  if (t >= 1) return takePose(step, to);
  return step.curves.reduce((held, curve) => {
    const [a, b] = [from, to].map((pose) => pose.curves.find((each) => each.id === curve.id) ?? {});
    const posture = betweenPostures(curve, a as CurvePosture, b as CurvePosture, t);
    return updateCurve(held, curve.id, { ...REST, ...posture });
  }, step);
}

const REST = { posed: undefined, base: undefined, twist: undefined, scale: undefined } as const;

function betweenPostures(curve: Curve, a: CurvePosture, b: CurvePosture, t: number): CurvePosture {
  const { rest, anchor } = curve;
  const out: { -readonly [F in keyof CurvePosture]: CurvePosture[F] } = {};
  if (a.posed || b.posed) {
    const [from, to] = [a.posed ?? rest, b.posed ?? rest];
    // The walk begins at the end that stays, so that what differs there does not add up on the way.
    const backwards = anchor === 'end';
    const walked = backwards ? walk(from.toReversed(), to.toReversed(), t).reverse() : walk(from, to, t);
    out.posed = walked;
  }
  if (a.base || b.base) out.base = turned(a.base ?? STILL, b.base ?? STILL, t);
  if (a.twist || b.twist) out.twist = rest.map((_, k) => mixed(a.twist?.[k] ?? 0, b.twist?.[k] ?? 0, t));
  if (a.scale || b.scale)
    out.scale = rest.map((_, k) => {
      const [p, q] = [a.scale?.[k] ?? EVEN, b.scale?.[k] ?? EVEN];
      return [mixed(p[0], q[0], t), mixed(p[1], q[1], t)];
    });
  return out;
}

const STILL: Quaternion = [0, 0, 0, 1];
const EVEN: [number, number] = [1, 1];

const mixed = (a: number, b: number, t: number): number => a + t * (b - a);

function walk(from: readonly Point[], to: readonly Point[], t: number): Point[] {
  const out: Point[] = [from[0]!.map((x, k) => mixed(x, to[0]![k]!, t)) as Point];
  for (let i = 1; i < from.length; i++) {
    const a = from[i]!.map((x, k) => x - from[i - 1]![k]!) as Point;
    const b = to[i]!.map((x, k) => x - to[i - 1]![k]!) as Point;
    const by = swung(a, b, t);
    out.push(out[i - 1]!.map((x, k) => x + by[k]!) as Point);
  }
  return out;
}

/** From one vector to another: its length at an even pace, its direction along the great circle. */
function swung(a: Point, b: Point, t: number): Point {
  const [la, lb] = [Math.hypot(...a), Math.hypot(...b)];
  const length = mixed(la, lb, t);
  if (!(la > 0) || !(lb > 0)) return a.map((x, k) => mixed(x, b[k]!, t)) as Point;
  const [p, q] = [a.map((x) => x / la), b.map((x) => x / lb)];
  return slerp(p, q, t).map((x) => length * x) as Point;
}

/** Between unit vectors of any dimension; straight across where they are alike or opposite. */
function slerp(p: readonly number[], q: readonly number[], t: number): number[] {
  const cosine = Math.min(
    1,
    Math.max(
      -1,
      p.reduce((sum, x, k) => sum + x * q[k]!, 0),
    ),
  );
  const angle = Math.acos(cosine);
  const sine = Math.sin(angle);
  if (sine < 1e-6) return p.map((x, k) => mixed(x, q[k]!, t));
  return p.map((x, k) => (Math.sin((1 - t) * angle) * x + Math.sin(t * angle) * q[k]!) / sine);
}

function turned(a: Quaternion, b: Quaternion, t: number): Quaternion {
  const [la, lb] = [Math.hypot(...a), Math.hypot(...b)];
  const p = a.map((x) => x / la);
  const dot = p.reduce((sum, x, k) => sum + (x * b[k]!) / lb, 0);
  // q and −q are one rotation; the nearer of them is meant.
  const q = b.map((x) => (dot < 0 ? -x : x) / lb);
  const out = slerp(p, q, t);
  const length = Math.hypot(...out);
  return out.map((x) => Math.min(1, Math.max(-1, x / length))) as Quaternion;
}

/** A name that no pose has yet. */
export const freePoseName = ({ poses }: CurvesStep, base: string): string =>
  freeName(
    base,
    poses.map(({ name }) => name),
  );

/** Whether the curves stand as the pose has them. */
export const standsIn = (step: CurvesStep, pose: CurvePose): boolean =>
  step.curves.every((curve) => {
    const { id: _, ...held } = pose.curves.find(({ id }) => id === curve.id) ?? { id: '' };
    return JSON.stringify(postureOf(curveById(step, curve.id)!)) === JSON.stringify(postureOf(held));
  });

/** Seconds from one pose to the next that says no time. */
const PACE = 0.8;

/**
 * When each pose is reached, in seconds, and when the first is again: at once where the last is the first once more, which
 * closes a round.
 */
export function beginnings(poses: readonly Pick<CurvePose, 'time' | 'curves'>[]): number[] {
  const out: number[] = [];
  for (const { time } of poses) {
    const before = out.at(-1);
    if (before === undefined) out.push(0);
    else out.push(time !== undefined && time > before ? time : before + PACE);
  }
  const closed =
    poses.length > 2 && JSON.stringify(poses.at(-1)!.curves) === JSON.stringify(poses[0]!.curves);
  return [...out, out.at(-1)! + (closed ? 0 : PACE)];
}
