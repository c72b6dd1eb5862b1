// How a fitting is computed for the screen: the map between the bodies once, then the ease as often as it changes.

import { isCancelled, LissomError } from '../../core/errors';
import type { DressStep } from '../../recipe/recipe';
import type { Evaluating, Outcome, Request, Strategy } from '../evaluated';
import { sameBefore } from '../strategy';

export const dressStrategy: Strategy<DressStep> = {
  busy: 'busy.dressing',

  /** Both need the same map. */
  worthWaiting: ({ step: last, ...a }, { step: next, ...b }) =>
    last.id === next.id &&
    last.garment === next.garment &&
    last.match === next.match &&
    last.from === next.from &&
    last.to === next.to &&
    sameBefore({ ...a, step: last }, { ...b, step: next }),

  async run(request, evaluating) {
    const bare = await undressed(request, evaluating);
    const { before, show } = evaluating;
    // What is not on screen yet is seen at once: to match bodies takes its time.
    if (before?.shown !== bare.shown || before.wearer !== bare.wearer) show(bare);
    try {
      return await dressed(request, evaluating, bare);
    } catch (error) {
      if (!(error instanceof LissomError) || isCancelled(error) || error.fault !== 'input') throw error;
      return { ...bare, problem: error };
    }
  },
};

/** The garment as it was, beside the body that is to wear it. */
async function undressed(
  { recipe, step }: Request<DressStep>,
  { runner, signal }: Pick<Evaluating, 'runner' | 'signal'>,
): Promise<Outcome & { readonly shown: Outcome['shown'] }> {
  const garment = await runner.opened(recipe, step.garment, { signal });
  const wearer = await runner.opened(recipe, step.to, { signal });
  return { inputs: [garment], shown: garment, positions: garment.model.positions, wearer };
}

async function dressed(
  { recipe, step }: Request<DressStep>,
  { runner, signal, onProgress, settle }: Evaluating,
  { shown, wearer = null }: Outcome,
): Promise<Outcome> {
  const results = await runner.run(recipe, { signal, onProgress, until: step.id, settle });
  const { inputs, model, report } = results.get(step.id)!;
  return { inputs, shown, positions: model.positions, wearer, report };
}
