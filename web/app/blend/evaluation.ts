// How a blend is computed for the screen: weights move on the graphics card while the hand moves them, and what remains is
// the kernel's.

import { isCancelled, LissomError } from '../../core/errors';
import { LastMade } from '../../core/last-made';
import { stepById } from '../../recipe/edit';
import type { BlendStep } from '../../recipe/recipe';
import { mainInput } from '../../recipe/references';
import type { Weights } from '../../tools/blend/weights';
import { MorphMotion } from '../../view/blend/morph-motion';
import type { Evaluating, Evaluation, Outcome, Request, Strategy } from '../evaluated';
import { atRest, sameBefore } from '../strategy';
import type { BlendState, Skins } from './state';

type BlendRequest = Request<BlendStep>;

export function blendStrategy(own: Pick<BlendState, 'movable' | 'skins'>): Strategy<BlendStep> {
  const sums = new LastMade<Skins, MorphMotion>();
  /** With what the exact result has beside the sum, by the exact result. */
  const corrected = new LastMade<Float64Array, MorphMotion>();
  /** The weights that an exact result was asked for by. */
  const asked = new WeakMap<Float64Array, Weights>();

  const dragged = async ({ step }: BlendRequest, before: Evaluation | null): Promise<Outcome | null> => {
    const skins = own.skins.peek();
    if (!before || !skins || !onlyWeightsDiffer(before, step) || skins.skin.key !== before.shown.key)
      return null;
    const { inputs, shown, positions, report } = before;
    const at = asked.get(positions);
    if (!at) return null;
    const motion = isPlain(step)
      ? await sums.of(skins, async () => motionOf(skins))
      : await corrected.of(positions, async () => motionOf(skins, beside(skins, positions, at)));
    const table = Float64Array.from(skins.names, (name) => step.weights[name] ?? 0);
    return { inputs, shown, positions, report, moved: { motion, table }, settled: false };
  };

  return {
    busy: 'busy.blending',

    /** Both need the same skins, and the same factors for the parts. */
    worthWaiting: (last, next) =>
      last.step.id === next.step.id &&
      last.step.match === next.step.match &&
      last.step.parts === next.step.parts &&
      sameBefore(last, next),

    async run(request, evaluating) {
      if (request.live && own.movable.peek()) {
        const moved = await dragged(request, evaluating.before);
        if (moved) return moved;
      }
      try {
        const blended = await exact(request, evaluating);
        asked.set(blended.positions, request.step.weights);
        return blended;
      } catch (error) {
        if (!(error instanceof LissomError) || isCancelled(error) || error.fault !== 'input') throw error;
        return { ...(await unblended(request, evaluating)), problem: error };
      }
    },
  };
}

/** Neither parts nor wanted measures: nothing but the sum. */
const isPlain = ({ parts, measures }: BlendStep): boolean =>
  parts.length === 0 && measures.every(({ value }) => value === undefined);

function onlyWeightsDiffer({ step: last, problem }: Evaluation, step: BlendStep): boolean {
  return (
    problem === null &&
    last.type === 'blend' &&
    last.id === step.id &&
    last.match === step.match &&
    last.parts === step.parts &&
    last.measures === step.measures
  );
}

const motionOf = ({ positions, skin }: Skins, more?: Float64Array): MorphMotion =>
  new MorphMotion({ positions, triangles: skin.opened.triangles, beside: more });

/** What an exact result has beside the sum of the skins by the weights that it was asked for by. */
function beside({ names, positions }: Skins, exactly: Float64Array, weights: Weights): Float64Array {
  const out = exactly.slice();
  for (const [k, name] of names.entries()) {
    const weight = weights[name] ?? 0;
    const skin = positions[k]!;
    if (weight !== 0) for (let i = 0; i < out.length; i++) out[i] = out[i]! - weight * skin[i]!;
  }
  return out;
}

/** The first skin with other positions: it stays the model on screen. */
async function exact(
  { recipe, step }: BlendRequest,
  { runner, signal, onProgress, settle }: Evaluating,
): Promise<Outcome> {
  const results = await runner.run(recipe, { signal, onProgress, until: step.id, settle });
  const { inputs, model, report } = results.get(step.id)!;
  return { inputs, shown: inputs[0]!, positions: model.positions, report };
}

/** The first skin as it is, or the model that it would be of where there is none. */
async function unblended(
  { recipe, step }: BlendRequest,
  { runner, signal }: Pick<Evaluating, 'runner' | 'signal'>,
): Promise<Outcome> {
  try {
    return atRest([await runner.opened(recipe, step.match, { signal })], 0);
  } catch (error) {
    const match = stepById(recipe, step.match);
    if (!match || isCancelled(error)) throw error;
    return atRest([await runner.opened(recipe, mainInput(match), { signal })], 0);
  }
}
