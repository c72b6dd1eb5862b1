import * as v from 'valibot';
import { MAX_HANDLES } from '../limits';
import { between, listUpTo, reference, severalReference, stepId, vertexSet } from '../schema-parts';
import type { Member } from '../step-row';

/** The pose once more on top of itself; beyond that limbs run through bodies. */
export const MAX_STRENGTH = 2;

/**
 * Gives a model the pose of another (Isolines sec. 6). `like` names the deform step that has the pose; `handles` are vertex sets
 * of this step's model, one for each handle of that step and in its order: what is held there is here. An empty one
 * stands for a handle that has no counterpart. Of models that a match step brought to one connectivity nothing need be paired: with
 * `through` there are no handles, and `like` may be any step that poses one of them.
 */
export const transferStep = v.strictObject({
  id: stepId,
  type: v.literal('transfer'),
  model: reference,
  like: reference,
  handles: v.optional(listUpTo(MAX_HANDLES, vertexSet), []),
  /** 0 leaves the model as it is, 1 gives it the whole pose. */
  strength: v.optional(between(0, MAX_STRENGTH), 1),
  /** Whether what the pose stretches is stretched here too; else the surface only turns. */
  keepStretch: v.optional(v.boolean(), false),
  /** A match of both models: the pose goes from skin to skin. */
  through: v.optional(severalReference),
});

export type TransferStep = v.InferOutput<typeof transferStep>;

/** What a match calls a model of its own, or the skin of one. */
export const memberOf = (match: string, name: string): string =>
  name.startsWith(`${match}/`) ? name.slice(match.length + 1) : name;

/** @param posedBy  what a step poses */
export function transferMembers(
  { through, model, like }: TransferStep,
  posedBy: (step: string) => string | undefined,
): Member[] {
  if (through === undefined) return [];
  const posed = posedBy(like);
  return [
    { path: ['model'], name: memberOf(through, model) },
    ...(posed === undefined ? [] : [{ path: ['like'], name: memberOf(through, posed) }]),
  ];
}

/** A transfer step as it starts: nothing is paired yet. @param handles  how many the pose has */
export const newTransferStep = (id: string, model: string, like: string, handles: number): TransferStep =>
  v.parse(transferStep, {
    id,
    type: 'transfer',
    model,
    like,
    handles: Array.from({ length: handles }, () => []),
  });
