// Pure edits of what a match step says of its models. Whatever has an entry for each model has it in their order.

import { isDrawn, type MarkerPlace, type MatchStep } from '../../recipe/steps/match';

export type Marker = MatchStep['markers'][number];
export type CurveRows = NonNullable<MatchStep['curves']>[number];

/** The step whose marker has its place on one model there; a number that there is none of begins a new marker. */
export function withPlace(
  step: MatchStep,
  marker: number,
  model: number,
  place: MarkerPlace | null,
): MatchStep {
  const held = step.markers[marker] ?? step.models.map(() => null);
  const next = held.map((each, at) => (at === model ? place : each));
  const markers = step.markers.map((each, at) => (at === marker ? next : each));
  if (marker >= markers.length) markers.push(next);
  return { ...step, markers: markers.filter(isSet) };
}

export const withoutMarker = (step: MatchStep, marker: number): MatchStep => ({
  ...step,
  markers: step.markers.filter((_, at) => at !== marker),
});

/** The step whose curve runs there on one model; a number that there is none of begins a new curve. */
export function withRow(step: MatchStep, curve: number, model: number, row: MarkerPlace[]): MatchStep {
  const held = step.curves?.[curve] ?? step.models.map(() => []);
  const next = held.map((each, at) => (at === model ? row : each));
  const curves = (step.curves ?? []).map((each, at) => (at === curve ? next : each));
  if (curve >= curves.length) curves.push(next);
  return withCurves(step, curves);
}

export const withoutCurve = (step: MatchStep, curve: number): MatchStep =>
  withCurves(
    step,
    (step.curves ?? []).filter((_, at) => at !== curve),
  );

/** The step with a picked edge along these vertices of a model; without any it is gone. */
export function withSharp(
  step: MatchStep,
  model: number,
  row: number,
  vertices: readonly number[],
): MatchStep {
  const held = step.sharp?.[model] ?? [];
  const next = held.map((each, at) => (at === row ? [...vertices] : each));
  if (row >= held.length) next.push([...vertices]);
  const kept = next.filter(({ length }) => length > 1);
  const sharp = step.models.map((_, at) => (at === model ? kept : (step.sharp?.[at] ?? [])));
  const { sharp: _, ...bare } = step;
  return sharp.every(({ length }) => length === 0) ? bare : { ...bare, sharp };
}

export function withMask(
  step: MatchStep,
  model: number,
  set: NonNullable<MatchStep['mask']>[number],
): MatchStep {
  const mask = step.models.map((_, at) => (at === model ? set : (step.mask?.[at] ?? [])));
  const { mask: _, ...bare } = step;
  return mask.every((each) => each !== 'all' && 'length' in each && each.length === 0)
    ? bare
    : { ...bare, mask };
}

/**
 * The step with other models, or in another order.
 *
 * @param from  for each of them which it was; `null`: a new one, on which nothing is marked
 */
export function withModels(
  step: MatchStep,
  models: readonly string[],
  from: readonly (number | null)[],
): MatchStep {
  const moved = <T>(entries: readonly T[], none: T): T[] =>
    from.map((at) => (at === null ? none : (entries[at] ?? none)));
  const { sharp, mask, curves = [], ...bare } = step;
  const next: MatchStep = {
    ...bare,
    models: [...models],
    markers: step.markers.map((marker) => moved(marker, null)).filter(isSet),
    ...(sharp && { sharp: moved(sharp, []) }),
    ...(mask && { mask: moved(mask, []) }),
  };
  return withCurves(
    next,
    curves.map((rows) => moved(rows, [])),
  );
}

/** Numbers of the models on which a marker has no place yet. */
export const missing = (marker: Marker): number[] =>
  marker.flatMap((place, at) => (place === null ? [at] : []));

/** The marker that a press on a model is for: the selected one where it lacks that model, else a new one. */
export function markerFor({ markers }: MatchStep, selected: number | null, model: number): number {
  const marker = selected === null ? undefined : markers[selected];
  return marker && marker[model] === null ? selected! : markers.length;
}

/** The curve that a stroke on a model is for: the selected one until it is there on every model, else a new one. */
export function curveFor({ curves = [] }: MatchStep, selected: number | null): number {
  const rows = selected === null ? undefined : curves[selected];
  return rows && !isDrawn(rows) ? selected! : curves.length;
}

function withCurves({ curves: _, ...step }: MatchStep, curves: readonly CurveRows[]): MatchStep {
  const kept = curves.filter((rows) => rows.some(({ length }) => length > 0));
  return kept.length > 0 ? { ...step, curves: kept } : step;
}

const isSet = (marker: Marker): boolean => marker.some((place) => place !== null);
