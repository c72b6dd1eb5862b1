// Field, constraints and volume of the open hair step, drawn when they are asked for.

import { effect } from '@preact/signals';
import { Latest } from '../../core/latest';
import type { Recipe } from '../../recipe/recipe';
import type { Runner } from '../../run/evaluate';
import type { HairField } from '../../run/steps/hair';
import type { ViewportPort } from '../../view/types';
import type { Evaluator } from '../evaluation';
import type { State } from '../state';

/** Every how-manieth node of the field has an arrow. */
const STRIDE = 3;

interface Parts {
  readonly viewport: ViewportPort;
  readonly state: State;
  readonly evaluator: Pick<Evaluator, 'result'>;
  readonly runner: Pick<Runner, 'ask'>;
  readonly failed: (error: unknown) => void;
}

/** @returns the function that ends it */
export function syncField({ viewport, state, evaluator, runner, failed }: Parts): () => void {
  const draw = (field: HairField | null): void => {
    const { field: arrows, constraints, volume } = state.hair.show.peek();
    viewport.setField(field && arrows ? field : null);
    viewport.setConstraints(field && constraints ? field.constraints : null);
    viewport.setVolume(field && volume ? { low: field.low, high: field.high } : null);
  };
  const fetches = new Latest<{ readonly recipe: Recipe; readonly step: string }, HairField>({
    work: ({ recipe, step }, signal) => runner.ask(recipe, step, 'field', { stride: STRIDE }, { signal }),
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
