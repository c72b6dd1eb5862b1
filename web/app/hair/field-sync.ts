// Field, constraints and volume of the open hair step, drawn when they are asked for.

import { effect } from '@preact/signals';
import { Latest } from '../../core/latest';
import type { Recipe } from '../../recipe/recipe';
import type { Answer } from '../../run/steps/all';
import type { WingParts } from '../wing-parts';
import type { HairLayers } from './layers';
import type { HairState } from './state';

/** Every how-manieth node of the field has an arrow. */
const STRIDE = 3;

type Field = Answer<'field'>;

/** @returns the function that ends it */
export function syncField(
  { field: arrows, box }: Pick<HairLayers, 'field' | 'box'>,
  { evaluator, runner, messages }: Pick<WingParts, 'evaluator' | 'runner' | 'messages'>,
  { show }: Pick<HairState, 'show'>,
): () => void {
  const draw = (field: Field | null): void => {
    const wanted = show.peek();
    arrows.setField(field && wanted.field ? field : null);
    arrows.setConstraints(field && wanted.constraints ? field.constraints : null);
    box.setVolume(field && wanted.volume ? { low: field.low, high: field.high } : null);
  };
  const fetches = new Latest<{ readonly recipe: Recipe; readonly step: string }, Field>({
    work: ({ recipe, step }, signal) => runner.ask(recipe, step, 'field', { stride: STRIDE }, { signal }),
    deliver: draw,
    fail: (error) => messages.failed(error),
  });
  const stop = effect(() => {
    const evaluation = evaluator.result.value;
    const { field, constraints, volume } = show.value;
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
