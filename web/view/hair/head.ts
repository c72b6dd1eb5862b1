import type { BufferGeometry } from 'three';

/** The head the hair grows on, drawn units. */
export interface Head {
  readonly geometry: BufferGeometry;
  readonly places: Float32Array;
  readonly triangles: Uint32Array;
}
