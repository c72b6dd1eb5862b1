// The model on screen follows the results, whichever workspace is open: shape, display options, no stale brush.

import { computed, effect, type ReadonlySignal } from '@preact/signals';
import type { Model } from '../core/model';
import type { ModelResult } from '../run/types';
import type { ViewModel, ViewportPort } from '../view/types';
import type { Evaluation, EvaluatorPort } from './evaluated';
import type { State } from './state';

/** A model ready to draw. */
export function viewModel(
  model: Model,
  { triangles, welded }: Pick<ViewModel, 'triangles' | 'welded'>,
): ViewModel {
  const { positions, faceOffsets, faceVertices, colors, upAxis } = model;
  const more = { ...(colors && { colors }), ...(upAxis && { upAxis }) };
  return { positions, triangles, faceOffsets, faceVertices, welded, ...more };
}

/** What the open step's own pictures are made of: nothing while a file is looked at in its place. */
export const besidesViewing = (
  { viewing }: Pick<State, 'viewing'>,
  { result }: Pick<EvaluatorPort, 'result'>,
): ReadonlySignal<Evaluation | null> => computed(() => (viewing.value ? null : result.value));

/** @returns the function that ends it */
export function syncModel(
  viewport: ViewportPort,
  { display }: Pick<State, 'display'>,
  result: ReadonlySignal<Evaluation | null>,
): () => void {
  let shown: Evaluation | null = null;
  const stops = [
    effect(() => {
      const evaluation = result.value;
      if (evaluation) show(viewport, evaluation, shown);
      else if (shown) viewport.setModel(null);
      shown = evaluation;
    }),
    effect(() => viewport.setDisplay(display.value)),
  ];
  return () => {
    for (const stop of stops) stop();
  };
}

function show(viewport: ViewportPort, next: Evaluation, before: Evaluation | null): void {
  const { model, opened, key } = standing(next);
  const last = before && standing(before);
  // A new worker opens the same model anew: that alone must not end what the hand is doing.
  const isShown =
    last?.key === key && last.model.colors === model.colors && last.model.upAxis === model.upAxis;
  if (!isShown) {
    const keepCamera = last?.model.faceVertices === model.faceVertices;
    viewport.setModel(viewModel(model, opened), { keepCamera });
  }
  if (!isShown || placesOf(next) !== (before && placesOf(before))) viewport.setPositions(placesOf(next));
  if (next.settled) viewport.settlePositions();
}

const standing = ({ wearer, shown }: Evaluation): ModelResult => wearer ?? shown;
const placesOf = ({ wearer, positions }: Evaluation): Float64Array => wearer?.model.positions ?? positions;
