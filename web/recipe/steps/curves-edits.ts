// Edits of one curves step as pure functions: a step in, another out. What changes nothing returns the very same step.

import { freeName } from '../names';
import type { Curve, CurvePosture, CurvesStep } from './curves';

export type CurveLink = CurvesStep['links'][number];
export type CurvePose = CurvesStep['poses'][number];
type Point = Curve['rest'][number];

export const curveById = ({ curves }: CurvesStep, id: string): Curve | undefined =>
  curves.find((curve) => curve.id === id);

/** An id for a new curve. */
export const freeCurveId = ({ curves }: CurvesStep, base: string): string =>
  freeName(
    base,
    curves.map(({ id }) => id),
  );

export const addCurve = (step: CurvesStep, curve: Curve): CurvesStep => ({
  ...step,
  curves: [...step.curves, curve],
});

/** Its links go with it, and its part of every pose. */
export const removeCurve = (step: CurvesStep, id: string): CurvesStep => ({
  ...step,
  curves: step.curves.filter((curve) => curve.id !== id),
  links: step.links.filter(({ child, parent }) => child !== id && parent !== id),
  poses: step.poses.map((pose) => ({ ...pose, curves: pose.curves.filter((curve) => curve.id !== id) })),
});

/** Wherever its name stands. A name that another curve has is left alone. */
export function renameCurve(step: CurvesStep, id: string, to: string): CurvesStep {
  if (to === id || to === '' || curveById(step, to)) return step;
  const renamed = (name: string): string => (name === id ? to : name);
  return {
    ...step,
    curves: step.curves.map((curve) => ({ ...curve, id: renamed(curve.id) })),
    links: step.links.map(({ child, parent, at }) => ({
      child: renamed(child),
      parent: renamed(parent),
      at,
    })),
    poses: step.poses.map((pose) => ({
      ...pose,
      curves: pose.curves.map((curve) => ({ ...curve, id: renamed(curve.id) })),
    })),
  };
}

/** @param patch  fields to set; one that is `undefined` is removed */
export const updateCurve = (
  step: CurvesStep,
  id: string,
  patch: { readonly [F in keyof Curve]?: Curve[F] | undefined },
): CurvesStep => ({
  ...step,
  curves: step.curves.map((curve) => (curve.id === id ? (without({ ...curve, ...patch }) as Curve) : curve)),
});

const without = (fields: object): object =>
  Object.fromEntries(Object.entries(fields).filter(([, value]) => value !== undefined));

/** Where the control points are: the posed ones, else those at rest. */
export const pointsOf = ({ rest, posed }: Pick<Curve, 'rest' | 'posed'>): readonly Point[] => posed ?? rest;

export const postureOf = ({ posed, base, twist, scale }: CurvePosture): CurvePosture =>
  without({ posed, base, twist, scale }) as CurvePosture;

const AT_REST = { posed: undefined, base: undefined, twist: undefined, scale: undefined } as const;

export const isPosed = (curve: CurvePosture): boolean => Object.keys(postureOf(curve)).length > 0;

/** One curve, or all of them, as at rest. */
export const resetCurves = (step: CurvesStep, id?: string): CurvesStep =>
  step.curves.reduce(
    (held, curve) =>
      (id === undefined || curve.id === id) && isPosed(curve) ? updateCurve(held, curve.id, AT_REST) : held,
    step,
  );

export const toggleRigid = (step: CurvesStep, id: string, segment: number): CurvesStep => {
  const rigid = new Set(curveById(step, id)?.rigid);
  if (!rigid.delete(segment)) rigid.add(segment);
  return updateCurve(step, id, { rigid: rigid.size > 0 ? [...rigid].sort((a, b) => a - b) : undefined });
};

/** The link by which a curve hangs on another. */
export const linkOf = ({ links }: CurvesStep, child: string): CurveLink | undefined =>
  links.find((link) => link.child === child);

/** Whether one curve hangs on another, or on one that does. */
export function hangsOn(step: CurvesStep, id: string, above: string): boolean {
  const link = linkOf(step, id);
  return link !== undefined && (link.parent === above || hangsOn(step, link.parent, above));
}

/** Hangs one curve on another, and off whatever it hung on. Nothing where that would close a ring. */
export function linkCurves(step: CurvesStep, { child, parent, at }: CurveLink): CurvesStep {
  if (child === parent || hangsOn(step, parent, child)) return step;
  const others = step.links.filter((link) => link.child !== child);
  return { ...step, links: [...others, { child, parent, at }] };
}

export const unlinkCurve = (step: CurvesStep, child: string): CurvesStep =>
  linkOf(step, child) ? { ...step, links: step.links.filter((link) => link.child !== child) } : step;

/** The parameter of a control point along its curve: 0 at the start, 1 at the end. */
export const parameterOf = ({ rest }: Pick<Curve, 'rest'>, point: number): number =>
  point / (rest.length - 1);

/** A curve with ends moved in along its control points; the posture goes, it was of others. */
export const trimmed = (curve: Curve, rest: Curve['rest']): Curve =>
  without({ ...curve, ...AT_REST, rigid: undefined, region: undefined, rest }) as Curve;
