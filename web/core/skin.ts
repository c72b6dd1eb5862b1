/** Where a joint is: place, rotation (x, y, z, w) and scale, ten numbers. */
export const JOINT = 10;

/** What moves a model by joints: the same for every program that knows skins. The first joint is the model at rest. */
export interface Skin {
  /** Names of the joints. */
  readonly joints: readonly string[];
  /** Where they are while the model is at rest, `JOINT` numbers each, model space. */
  readonly rest: Float64Array;
  /** Where they are in the pose that is shown. */
  readonly posed: Float64Array;
  /** Four joints a vertex. */
  readonly indices: Uint16Array;
  /** Theirs; they sum to 1. */
  readonly weights: Float32Array;
  /** Poses by time in seconds, ascending; empty where nothing is played. */
  readonly keys: readonly { readonly time: number; readonly joints: Float64Array }[];
}
