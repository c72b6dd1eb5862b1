import type { Affine } from './affine';

export interface RigJoint {
  readonly name: string;
  /** The joint that it hangs from, by number; −1: none. */
  readonly parent: number;
  /** From the joint's space to the model's, while the model is at rest. */
  readonly bind: Affine;
}

/** Joints that a model brings along, and how much each of its vertices goes with each of them. */
export interface Rig {
  readonly joints: readonly RigJoint[];
  /** Joints a vertex: glTF has them in sets of four. */
  readonly influences: 4 | 8;
  /** `influences` joints a vertex. */
  readonly indices: Uint16Array;
  /** Theirs; they sum to 1. */
  readonly weights: Float32Array;
}

/** Writes whose a vertex is: the largest shares of joints, as many as it can have, made to sum to 1. Equal ones stay in their order. */
export function keepLargest(
  { influences, indices, weights }: Pick<Rig, 'influences' | 'indices' | 'weights'>,
  vertex: number,
  shares: readonly (readonly [joint: number, share: number])[],
): void {
  const kept = [...shares].sort(([, a], [, b]) => b - a).slice(0, influences);
  const sum = kept.reduce((all, [, share]) => all + share, 0);
  for (const [k, [joint, share]] of kept.entries()) {
    indices[influences * vertex + k] = joint;
    weights[influences * vertex + k] = share / sum;
  }
}
