import * as v from 'valibot';
import { MAX_HANDLES } from '../limits';
import { between, listUpTo, reference, stepId, vertexSet } from '../schema-parts';

/** The pose once more on top of itself; beyond that limbs run through bodies. */
export const MAX_STRENGTH = 2;

/**
 * Gives a model the pose of another (Isolines sec. 6). `like` names the deform step that has the pose; `handles` are vertex sets
 * of this step's model, one for each handle of that step and in its order: what is held there is here. An empty one
 * stands for a handle that has no counterpart.
 */
export const transferStep = v.strictObject({
  id: stepId,
  type: v.literal('transfer'),
  model: reference,
  like: reference,
  handles: listUpTo(MAX_HANDLES, vertexSet),
  /** 0 leaves the model as it is, 1 gives it the whole pose. */
  strength: v.optional(between(0, MAX_STRENGTH), 1),
  /** Whether what the pose stretches is stretched here too; else the surface only turns. */
  keepStretch: v.optional(v.boolean(), false),
});

export type TransferStep = v.InferOutput<typeof transferStep>;

/** A transfer step as it starts: nothing is paired yet. @param handles  how many the pose has */
export const newTransferStep = (id: string, model: string, like: string, handles: number): TransferStep =>
  v.parse(transferStep, {
    id,
    type: 'transfer',
    model,
    like,
    handles: Array.from({ length: handles }, () => []),
  });
