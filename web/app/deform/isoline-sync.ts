// Isolines, harmonic fields and rigidity of the open step, drawn when they are asked for.

import { effect } from '@preact/signals';
import { Latest } from '../../core/latest';
import type { DeformStep, Recipe } from '../../recipe/recipe';
import { LEVELS } from '../../view/overlays/levels';
import type { ViewportPort } from '../../view/types';
import type { WingParts } from '../wing-parts';
import { heldAlike } from './evaluation';
import type { DeformState, IsolineView } from './state';

/** Lines on the surface: as many steps as the paper draws. */
const STEPS = 20;
/** Of the values, how many may lie above the end of the colours. */
const ABOVE = 0.02;

interface Wanted {
  readonly recipe: Recipe;
  /** Stands for the model that the step starts from. */
  readonly key: string;
  readonly step: DeformStep;
  readonly handle: number;
  readonly view: Exclude<IsolineView, 'nothing'>;
}

/** @returns the function that ends it */
export function syncIsolines(
  viewport: ViewportPort,
  { state, evaluator, runner, messages }: Pick<WingParts, 'state' | 'evaluator' | 'runner' | 'messages'>,
  own: Pick<DeformState, 'isolines' | 'field'>,
): () => void {
  const levels = viewport.mount(LEVELS);
  const draw = (shown: { readonly view: IsolineView; readonly values: Float32Array } | null): void => {
    levels.port.setLevels(shown?.view === 'lines' ? { values: shown.values, steps: STEPS } : null);
    own.field.value =
      shown && shown.view !== 'lines'
        ? { values: shown.values, range: shown.view === 'field' ? [0, 1] : [0, high(shown.values)] }
        : null;
  };
  const fetches = new Latest<Wanted, Parameters<typeof draw>[0]>({
    work: async ({ recipe, step, handle, view }, signal) => {
      const what = view === 'rigidity' ? 'rigidity' : 'field';
      const values = await runner.ask(recipe, step.id, 'handleField', { handle, what }, { signal });
      return values && { view, values };
    },
    deliver: draw,
    fail: (error) => messages.failed(error),
  });
  let last: Wanted | null = null;
  const stop = effect(() => {
    const evaluation = evaluator.result.value;
    const view = own.isolines.value;
    const handle = state.selection.value.item ?? 0;
    if (evaluation?.step.type !== 'deform' || view === 'nothing') {
      last = null;
      fetches.cancel();
      draw(null);
      return;
    }
    const { recipe, step, shown } = evaluation;
    const wanted = { recipe, key: shown.key, step, handle, view };
    if (last && sameField(last, wanted)) return;
    last = wanted;
    fetches.push(wanted);
  });
  return () => {
    stop();
    fetches.cancel();
    own.field.value = null;
    levels.unmount();
  };
}

/** Where the handles go changes nothing of it. */
const sameField = (a: Wanted, b: Wanted): boolean =>
  a.view === b.view && a.handle === b.handle && a.key === b.key && heldAlike(a.step, b.step);

/** The value that all but a few stay below. */
function high(values: Float32Array): number {
  const sorted = values.slice().sort();
  return sorted[Math.floor((1 - ABOVE) * (sorted.length - 1))] || 1;
}
