import * as v from 'valibot';
import { coordinate, memberName, reference, severalReference, stepId } from '../schema-parts';
import type { Member } from '../step-row';

/** A garment, or a shoe, made for one model, worn by another that a match step brought to one connectivity with it (Skins 5.2). */
export const dressStep = v.strictObject({
  id: stepId,
  type: v.literal('dress'),
  /** In the space of `from`. */
  garment: reference,
  match: severalReference,
  /** The model that it was made for. */
  from: memberName,
  to: memberName,
  /** Ease: how much farther from the body than it was, in units of `to`; less than 0: tighter. */
  offset: v.optional(coordinate, 0),
});

export type DressStep = v.InferOutput<typeof dressStep>;

export const dressMembers = ({ from, to }: DressStep): Member[] => [
  { path: ['from'], name: from },
  { path: ['to'], name: to },
];

/** A dress step as it starts. */
export const newDressStep = (
  id: string,
  garment: string,
  match: string,
  from: string,
  to: string,
): DressStep => v.parse(dressStep, { id, type: 'dress', garment, match, from, to });
