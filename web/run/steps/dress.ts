// The dress step: what was made for one model is worn by another (Skins 5.2). The map between them once, then the ease is cheap.

import type { Finding } from '../../core/errors';
import { hashValue } from '../../core/hash';
import { faceCount, withPositions } from '../../core/model';
import type { InsideCount } from '../../kernel/contract/wear';
import type { DressStep } from '../../recipe/steps/dress';
import type { ModelResult } from '../types';
import { type StepOutcome, type StepRunner, signalOf } from './step-runner';

export interface DressFigures {
  /** Vertices of the garment within the body, and centres of its faces. */
  readonly inside: number;
  readonly insideCentres: number;
  /** Before it was pushed out. */
  readonly insideBefore: InsideCount;
  /** Of pushing out. */
  readonly iterations: number;
}

/** As the kernel tells it of a soup. */
const ONLY_SKIN: Finding = { code: 'model-without-inside', count: 1, examples: [], repaired: true };

export const dressRunner = {
  /** The one on screen, and the one to switch back to. */
  keeps: { prepareDress: 2 },

  /** It names no vertices. */
  check: () => {},

  vertexCount: ([garment]) => garment?.vertices,

  content: ({ from, to, offset }) => ({ from, to, offset }),

  async run(step, context): Promise<StepOutcome<DressFigures>> {
    const [garment, skin] = context.inputs as [ModelResult, ModelResult];
    const { models, inputs } = context.origins[1]!;
    const skins = models!;
    const names = Object.keys(skins);
    const body = inputs[names.indexOf(step.to)]!;
    // The surface that is drawn through points joins limbs that are close, and legs would be told to be inside of it.
    const isSurface = faceCount(body.model) > 0;
    // It may be long since the match was made.
    const opened = isSurface
      ? (await context.kernel.open(body.model, context.signal, body.key)).opened
      : undefined;
    const prepared = await context.kernel.hold(
      'prepareDress',
      hashValue({ garment: garment.key, skins: skin.key, from: step.from, to: step.to }),
      {
        garment: garment.opened.id,
        triangles: skin.model.faceVertices,
        from: skins[step.from]!.positions,
        to: skins[step.to]!.positions,
        model: opened?.id,
      },
      { ...signalOf(context), onProgress: (fraction) => context.onProgress(0.8 * fraction) },
    );
    const dressed = await context.kernel.call(
      'dress',
      { dress: prepared.id, offset: step.offset },
      signalOf(context),
    );
    return {
      model: withPositions(garment.model, dressed.positions),
      figures: {
        inside: dressed.after.vertices,
        insideCentres: dressed.after.faceCentres,
        insideBefore: dressed.before,
        iterations: dressed.rounds,
      },
      seconds: { ...prepared.seconds, ...dressed.seconds },
      peakBytes: prepared.peakBytes,
      warnings: [...dressed.warnings, ...(isSurface ? [] : [ONLY_SKIN])],
    };
  },
} satisfies StepRunner<DressStep>;
