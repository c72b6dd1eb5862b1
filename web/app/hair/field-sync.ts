// Field, constraints and volume of the open hair step, drawn when they are asked for.

import { effect } from '@preact/signals';
import { Latest } from '../../core/latest';
import type { Recipe } from '../../recipe/recipe';
import type { Runner } from '../../run/evaluate';
import type { HairField } from '../../run/steps/hair';
import type { Evaluator } from '../evaluation';
import type { Layers } from '../layers';
import type { State } from '../state';

/** Every how-manieth node of the field has an arrow. */
const STRIDE = 3;

interface Parts {
  readonly layers: Pick<Layers, 'field' | 'box'>;
  readonly state: State;
  readonly evaluator: Pick<Evaluator, 'result'>;
  readonly runner: Pick<Runner, 'hairField'>;
  readonly failed: (error: unknown) => void;
}

/** @returns the function that ends it */
export function syncField({ layers, state, evaluator, runner, failed }: Parts): () => void {
  const draw = (field: HairField | null): void => {
    const { field: arrows, constraints, volume } = state.hair.show.peek();
    layers.field.setField(field && arrows ? field : null);
    layers.field.setConstraints(field && constraints ? field.constraints : null);
    layers.box.setVolume(field && volume ? { low: field.low, high: field.high } : null);
  };
  const fetches = new Latest<{ readonly recipe: Recipe; readonly step: string }, HairField>({
    work: ({ recipe, step }, signal) => runner.hairField(recipe, step, { stride: STRIDE, signal }),
    deliver: draw,
    fail: failed,
  });
  const stop = effect(() => {
    const evaluation = evaluator.result.value;
    const { field, constraints, volume } = state.hair.show.value;
    if (evaluation?.step.type !== 'hair' || !evaluation.report || !(field || constraints || volume)) {
      fetches.cancel();
      draw(null);
    } else fetches.push({ recipe: evaluation.recipe, step: evaluation.step.id });
  });
  return () => {
    stop();
    fetches.cancel();
  };
}
