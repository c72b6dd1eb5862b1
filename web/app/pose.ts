// How a thing stands, in the numbers that people type.

/** Angles in degrees, about the thing's middle at rest: x first, then y, then z, about the model's axes. */
export interface Pose {
  readonly translation: readonly [number, number, number];
  readonly rotation: readonly [number, number, number];
  readonly scale: readonly [number, number, number];
}
