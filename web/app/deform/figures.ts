// What the edit did to the model, measured once it has settled.

import { toIndices } from '../../core/vertex-set';
import type { Measured, OpenedModel } from '../../kernel/contract/model';
import type { DeformHandle, DeformStep } from '../../recipe/recipe';
import { pointAt, transform } from '../../tools/geometry';
import type { Evaluation } from '../evaluated';
import type { WingParts } from '../wing-parts';
import type { DeformState, WhatItDid } from './state';

/** A handle counts as met when none of its vertices is further off than this part of the model's extent. */
const EXACT = 1e-9;

type Deformed = Evaluation & { readonly step: DeformStep };

export class EffectFigures {
  #abort = new AbortController();

  constructor(
    private readonly own: Pick<DeformState, 'whatItDid' | 'stretch'>,
    private readonly parts: Pick<WingParts, 'runner' | 'messages'>,
  ) {}

  publish(shown: Evaluation | null): void {
    this.#abort.abort();
    this.#abort = new AbortController();
    if (!shown?.report) {
      this.own.whatItDid.value = null;
      this.own.stretch.value = null;
    } else if (shown.settled)
      this.#measure(shown as Deformed, this.#abort.signal).catch((error: unknown) =>
        this.parts.messages.failed(error),
      );
  }

  /** The result is known to the runner, so this only measures. */
  async #measure(evaluation: Deformed, signal: AbortSignal): Promise<void> {
    const { recipe, step } = evaluation;
    const results = await this.parts.runner.run(recipe, { until: step.id, signal, measure: true });
    const measured = results.get(step.id)!.measured!;
    this.own.stretch.value = measured.stretch;
    this.own.whatItDid.value = whatItDid(evaluation, measured);
  }
}

export function whatItDid(evaluation: Deformed, measured: Measured): WhatItDid {
  const { step, shown, positions } = evaluation;
  const { volumeRatio, edgeRms, flippedTriangles } = measured;
  const worstStretch = measured.worstStretch - 1;
  const rest = shown.model.positions;
  const limit = EXACT * extent(rest);
  const met = step.handles.filter((handle) => gap(handle, rest, positions, shown.opened) <= limit).length;
  const closed = shown.opened.closed;
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
