// The status bar's numbers and "what the edit did", worked out from each result.

import { batch, effect } from '@preact/signals';
import type { Finding } from '../core/errors';
import { faceCount, vertexCount } from '../core/model';
import { toIndices } from '../core/vertex-set';
import type { Measured, OpenedModel } from '../kernel/contract/model';
import type { DeformHandle, DeformStep } from '../recipe/recipe';
import type { Runner } from '../run/evaluate';
import type { ModelResult } from '../run/types';
import { pointAt, transform } from '../tools/geometry';
import type { Evaluation, Evaluator } from './evaluation';
import { hairFigures } from './hair/figures';
import { mergeFigures } from './merge/evaluation';
import type { ModelFacts, State, WhatItDid } from './state';

export const factsOf = ({ model, opened }: Pick<ModelResult, 'model' | 'opened'>): ModelFacts => ({
  name: model.name,
  vertices: vertexCount(model),
  faces: faceCount(model),
  components: opened.components,
  boundaryLoops: opened.boundaryLoops,
  closed: opened.closed,
});

/** A handle counts as met when none of its vertices is further off than this part of the model's extent. */
const EXACT = 1e-9;

/** @returns the function that ends it */
export function syncFigures(
  state: State,
  evaluator: Pick<Evaluator, 'result'>,
  runner: Pick<Runner, 'run'>,
  failed: (error: unknown) => void,
): () => void {
  let abort = new AbortController();
  return effect(() => {
    const evaluation = evaluator.result.value;
    abort.abort();
    abort = new AbortController();
    batch(() => publish(state, evaluation));
    if (!evaluation?.settled || !evaluation.report) return;
    const { step } = evaluation;
    if (step.type === 'deform')
      measure(runner, evaluation, abort.signal)
        .then((measured) => {
          state.stretch.value = measured.stretch;
          state.whatItDid.value = whatItDid({ ...evaluation, step }, measured);
        })
        .catch(failed);
  });
}

/** The result is known to the runner, so this only measures. */
async function measure(
  runner: Pick<Runner, 'run'>,
  { recipe, step }: Evaluation,
  signal: AbortSignal,
): Promise<Measured> {
  const results = await runner.run(recipe, { until: step.id, signal, measure: true });
  return results.get(step.id)!.measured!;
}

function publish(state: State, evaluation: Evaluation | null): void {
  if (!evaluation) {
    state.model.value = null;
    state.facts.value = null;
    state.whatItDid.value = null;
    state.stretch.value = null;
    state.warnings.value = [];
    state.hair.figures.value = null;
    state.merge.figures.value = null;
    return;
  }
  const { input, report, settled, elapsed } = evaluation;
  const old = state.figures.peek();
  const facts = factsOf(input);
  if (state.model.peek() !== input.model) {
    state.model.value = input.model;
    state.facts.value = facts;
  }
  const { factor, solve = 0, rotate = 0, reconstruct = 0 } = report?.seconds ?? {};
  state.figures.value = {
    ...old,
    vertices: facts.vertices,
    faces: facts.faces,
    free: report && 'free' in report ? report.free : null,
    factor: factor ? 1000 * factor : report ? old.factor : null,
    solve: report ? 1000 * (solve + rotate + reconstruct) : null,
    drag: settled ? old.drag : elapsed,
  };
  const isHair = evaluation.step.type === 'hair';
  state.hair.figures.value = isHair ? hairFigures(evaluation, state.hair.figures.peek()) : null;
  state.merge.figures.value = mergeFigures(evaluation);
  state.warnings.value = warningsOf(evaluation, state);
  if (evaluation.step.type !== 'deform' || !report) {
    state.whatItDid.value = null;
    state.stretch.value = null;
  }
}

/**
 * A head is open at the neck and has eyes: what its file is like is no news where hair is grown, nor is it where models
 * are put together.
 */
function warningsOf({ step, report, input }: Evaluation, { merge }: State): readonly Finding[] {
  const all = report?.warnings ?? [];
  if (step.type === 'deform') return all;
  const given = step.type === 'merge' ? merge.sides.peek().source?.opened : input.opened;
  const known = new Set(given?.findings.map(({ code }) => code));
  return all.filter(({ code }) => !known.has(code) && !FOUND.includes(code));
}

/** What a merge reports of its own finds: the pins and the seam show it. */
const FOUND = ['key-found', 'boundary-refined'];

export function whatItDid(
  evaluation: Evaluation & { readonly step: DeformStep },
  measured: Measured,
): WhatItDid {
  const { step, input, positions } = evaluation;
  const { volumeRatio, edgeRms, flippedTriangles } = measured;
  const worstStretch = measured.worstStretch - 1;
  const rest = input.model.positions;
  const limit = EXACT * extent(rest);
  const met = step.handles.filter((handle) => gap(handle, rest, positions, input.opened) <= limit).length;
  const closed = input.opened.closed;
  return {
    volumeRatio,
    closed,
    worstStretch,
    edgeRms,
    flippedTriangles,
    handlesMet: met,
    handles: step.handles.length,
  };
}

/** How far the worst vertex of a handle is from where the handle wants it. */
function gap(handle: DeformHandle, rest: Float64Array, posed: Float64Array, { welded }: OpenedModel): number {
  let worst = 0;
  for (const v of toIndices(handle.vertices, rest.length / 3)) {
    if (welded[v]! < 0) continue;
    const wanted = handle.kind === 'point' ? handle.position : transform(handle.matrix, pointAt(rest, v));
    const found = pointAt(posed, v);
    worst = Math.max(worst, Math.hypot(found[0] - wanted[0]!, found[1] - wanted[1]!, found[2] - wanted[2]!));
  }
  return worst;
}

function extent(positions: Float64Array): number {
  let [low, high] = [Infinity, -Infinity];
  let size = 0;
  for (let axis = 0; axis < 3; axis++) {
    [low, high] = [Infinity, -Infinity];
    for (let i = axis; i < positions.length; i += 3) {
      const x = positions[i]!;
      if (!Number.isFinite(x)) continue;
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
    if (high > low) size = Math.max(size, high - low, Math.abs(high), Math.abs(low));
  }
  return size;
}
