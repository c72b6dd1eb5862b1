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
