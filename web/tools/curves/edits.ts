// What gestures make of a curves step, pure.

import { roundTo } from '../../core/decimal';
import { product, type Quaternion, rotated } from '../../core/quaternion';
import type { Curve, CurvesStep } from '../../recipe/steps/curves';
import {
  addCurve,
  curveById,
  freeCurveId,
  linkCurves,
  linkOf,
  parameterOf,
  pointsOf,
  trimmed,
  updateCurve,
} from '../../recipe/steps/curves-edits';
import type { Vec3 } from '../../view/types';
import { add, dot, gap, subtract } from '../geometry';
import { placesFor } from '../stroke/polyline';
import type { Grip } from './items';
import { splineAt, tangentAt } from './spline';

type Point = Curve['rest'][number];
type Base = NonNullable<Curve['base']>;

/** Recipes keep few digits; a thousandth of the usual step of strokes cannot be seen, and drags stay smooth. */
export const kept = (point: Vec3, size: number): Point =>
  point.map((x) => roundTo(x, placesFor(size) + 2)) as Point;

/** Sets the control points of a curve; at rest again, they are left out. */
export function withPoints(
  step: CurvesStep,
  curve: Curve,
  points: readonly Vec3[],
  size: number,
): CurvesStep {
  const posed = points.map((point) => kept(point, size));
  const same = posed.every((point, i) => point.every((x, k) => x === curve.rest[i]![k]));
  return updateCurve(step, curve.id, { posed: same ? undefined : posed });
}

/** @param to  in the curve's own space */
export function movePoint(step: CurvesStep, { curve: at, point }: Grip, to: Vec3, size: number): CurvesStep {
  const curve = step.curves[at];
  if (!curve || point === null) return step;
  const points = pointsOf(curve).map((old, i): Vec3 => (i === point ? to : old));
  return withPoints(step, curve, points, size);
}

/** @param by  in the curve's own space */
export function moveCurve(step: CurvesStep, at: number, by: Vec3, size: number): CurvesStep {
  const curve = step.curves[at];
  if (!curve) return step;
  const points = pointsOf(curve).map((old) => add(old, by));
  return withPoints(step, curve, points, size);
}

/** How far a turn goes about an axis, degrees (the twist of its swing-twist parts). */
export function aboutAxis([x, y, z, w]: Quaternion, axis: Vec3): number {
  const degrees = (360 / Math.PI) * Math.atan2(dot([x, y, z], axis), w);
  return degrees > 180 ? degrees - 360 : degrees < -180 ? degrees + 360 : degrees;
}

/**
 * Turns what lies beyond a control point, seen from the end that stays, about that point. From the end that stays all
 * turns, and `base` says so.
 */
export function turnFrom(
  step: CurvesStep,
  { curve: at, point }: Grip,
  turn: Quaternion,
  anchor: 'start' | 'end',
  size: number,
): CurvesStep {
  const curve = step.curves[at];
  if (!curve) return step;
  const points = pointsOf(curve);
  const last = points.length - 1;
  const from = point ?? (anchor === 'start' ? 0 : last);
  const follows = (i: number): boolean => (anchor === 'start' ? i > from : i < from);
  const pivot = points[from]!;
  const moved = points.map((p, i): Vec3 => (follows(i) ? add(pivot, rotated(turn, subtract(p, pivot))) : p));
  const turned = withPoints(step, curve, moved, size);
  if (from === (anchor === 'start' ? 0 : last)) {
    const base = product(turn, curve.base ?? [0, 0, 0, 1]).map((x) => roundTo(x, 9)) as Base;
    return updateCurve(turned, curve.id, { base });
  }
  const by = aboutAxis(turn, tangentAt(points, from));
  if (Math.abs(by) < 1e-6) return turned;
  return twistBy(turned, at, by, (i) => Number(follows(i) || i === from));
}

/** The share that each control point has in a change of one of them. */
export type Share = (i: number) => number;

/**
 * The area of influence of Blanco 5.3: `range` 0 is the control point alone, 1 gives half to the next on each side, and so
 * on, evenly.
 */
export const influence =
  (point: number, range = 0): Share =>
  (i) =>
    Math.max(0, 1 - Math.abs(i - point) / (range + 1));

/** Adds to the twist of control points. */
export function twistBy(step: CurvesStep, at: number, degrees: number, share: Share): CurvesStep {
  const curve = step.curves[at];
  if (!curve) return step;
  const twist = curve.rest.map((_, i) => roundTo((curve.twist?.[i] ?? 0) + share(i) * degrees, 3));
  return updateCurve(step, curve.id, { twist: twist.every((x) => x === 0) ? undefined : twist });
}

export function setTwist(step: CurvesStep, { curve, point }: Grip, degrees: number, range = 0): CurvesStep {
  if (point === null) return step;
  const now = step.curves[curve]?.twist?.[point] ?? 0;
  return twistBy(step, curve, degrees - now, influence(point, range));
}

/** How wide the limb is across the curve at a control point, in shares of its width at rest. */
export function setScale(
  step: CurvesStep,
  { curve: at, point }: Grip,
  factors: [number, number],
  range = 0,
): CurvesStep {
  const curve = step.curves[at];
  if (!curve || point === null) return step;
  const share = influence(point, range);
  const now = curve.scale?.[point] ?? [1, 1];
  const scale = curve.rest.map((_, i): [number, number] => {
    const old = curve.scale?.[i] ?? [1, 1];
    const grown = (side: 0 | 1) => roundTo(old[side] * (factors[side] / now[side]) ** share(i), 4);
    return share(i) > 0 ? [grown(0), grown(1)] : [old[0], old[1]];
  });
  const even = scale.every(([a, b]) => a === 1 && b === 1);
  return updateCurve(step, curve.id, { scale: even ? undefined : scale });
}

/** Part of the way from one posture of all curves to another, in a straight line: where a drag is stopped. */
export function towards(from: CurvesStep, to: CurvesStep, share: number): CurvesStep {
  const part = (a: number, b: number): number => a + share * (b - a);
  return to.curves.reduce((held, { id, rest, posed, twist, scale }) => {
    const before = curveById(from, id);
    if (!before) return held;
    return updateCurve(held, id, {
      posed: posed?.map((p, i) => p.map((x, k) => part((before.posed ?? rest)[i]![k]!, x)) as Point),
      twist: twist?.map((x, i) => part(before.twist?.[i] ?? 0, x)),
      scale: scale?.map(([x, y], i): [number, number] => {
        const [a, b] = before.scale?.[i] ?? [1, 1];
        return [part(a, x), part(b, y)];
      }),
    });
  }, to);
}

/** The control point of the parent at which a linked curve begins; `null` where it hangs between two, or on none. */
export function jointOf(step: CurvesStep, at: number): Grip | null {
  const curve = step.curves[at];
  const link = curve && linkOf(step, curve.id);
  if (!link) return null;
  const parent = step.curves.findIndex(({ id }) => id === link.parent);
  const place = link.at * ((step.curves[parent]?.rest.length ?? 2) - 1);
  return Math.abs(place - Math.round(place)) < 1e-6 ? { curve: parent, point: Math.round(place) } : null;
}

/**
 * Hangs one curve on another at two of their control points: the child begins there. Where the link would close a ring
 * the step stays as it is.
 */
export function linkAt(step: CurvesStep, childGrip: Grip, parentGrip: Grip): CurvesStep {
  const [child, parent] = [step.curves[childGrip.curve], step.curves[parentGrip.curve]];
  if (!child || !parent || childGrip.point === null || parentGrip.point === null) return step;
  const at = parameterOf(parent, parentGrip.point);
  const linked = linkCurves(step, { child: child.id, parent: parent.id, at });
  if (linked === step) return step;
  const backwards = childGrip.point > (child.rest.length - 1) / 2;
  const ordered = backwards ? child.rest.toReversed() : child.rest;
  const rest = [parent.rest[parentGrip.point]!, ...ordered.slice(1)];
  const { id: _, ...begun } = trimmed({ ...child, anchor: 'start' }, rest);
  return updateCurve(linked, child.id, { ...NOTHING, ...begun });
}

const NOTHING = {
  posed: undefined,
  base: undefined,
  twist: undefined,
  scale: undefined,
  rigid: undefined,
  region: undefined,
} as const;

/** A step with a drawn curve; where it begins or ends on a control point of another, it hangs on that one. */
export function addDrawn(
  step: CurvesStep,
  kind: 'skeleton' | 'surface',
  points: readonly Vec3[],
  { name, near, size }: { readonly name: string; readonly near: number; readonly size: number },
): { readonly step: CurvesStep; readonly curve: number } {
  const rest = points.map((point) => kept(point, size));
  const id = freeCurveId(step, name);
  const curve = step.curves.length;
  const added = addCurve(step, { id, kind, rest });
  const ends = [0, rest.length - 1].flatMap((end) => {
    const met = nearestPoint(step, rest[end]!);
    return met && met.distance <= near ? [{ end, ...met }] : [];
  });
  ends.sort((a, b) => a.distance - b.distance);
  const [joint] = ends;
  return { step: joint ? linkAt(added, { curve, point: joint.end }, joint.grip) : added, curve };
}

/** The control point at rest that is nearest to a place. */
function nearestPoint({ curves }: CurvesStep, to: Vec3) {
  let best: { readonly grip: Grip; readonly distance: number } | null = null;
  curves.forEach(({ rest }, curve) => {
    rest.forEach((point, i) => {
      const distance = gap(point, to);
      if (!best || distance < best.distance) best = { grip: { curve, point: i }, distance };
    });
  });
  return best as { readonly grip: Grip; readonly distance: number } | null;
}

/** Across the plane x = 0. */
export const across = ([x, y, z]: Vec3): Vec3 => [x === 0 ? 0 : -x, y, z];

/** The curve once more, across x = 0; it hangs on what the curve hangs on. */
export function mirrorCurve(step: CurvesStep, at: number, name: string): CurvesStep {
  const curve = step.curves[at];
  if (!curve) return step;
  const id = freeCurveId(step, name);
  const { region: _, ...others } = curve;
  const copy: Curve = {
    ...others,
    id,
    rest: curve.rest.map((point) => across(point) as Point),
    ...(curve.posed && { posed: curve.posed.map((point) => across(point) as Point) }),
    ...(curve.base && { base: [curve.base[0], -curve.base[1], -curve.base[2], curve.base[3]] as Base }),
    ...(curve.twist && { twist: curve.twist.map((x) => (x === 0 ? 0 : -x)) }),
  };
  const link = linkOf(step, curve.id);
  const added = addCurve(step, copy);
  return link ? linkCurves(added, { ...link, child: id }) : added;
}

/** Whether a curve lies on the plane x = 0, so that its mirror image would be the curve itself. */
export const isOnPlane = (points: readonly Vec3[], near: number): boolean =>
  points.every(([x]) => Math.abs(x) <= near);

/** An end moved along the curve by a part of it: inwards above 0, straight on below. */
export function moveEnd(
  step: CurvesStep,
  at: number,
  end: 'start' | 'end',
  by: number,
  size: number,
): CurvesStep {
  const curve = step.curves[at];
  if (!curve) return step;
  const last = curve.rest.length - 1;
  const [low, high] = end === 'start' ? [by, 1] : [0, 1 - by];
  const rest = curve.rest.map((_, i) => kept(splineAt(curve.rest, low + ((high - low) * i) / last), size));
  const { id: _, ...moved } = trimmed(curve, rest);
  return updateCurve(step, curve.id, { ...NOTHING, ...moved });
}
