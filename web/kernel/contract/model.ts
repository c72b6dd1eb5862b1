import type { Finding } from '../../core/errors';

/** Something the kernel holds until `release`: whatever makes one answers `{ id, … }`. Dies with the worker. */
export type KernelId = number & { readonly brand: 'KernelId' };

/** What is held and moved: a part of the surface, or one point. */
export interface HandleSpec {
  readonly kind: 'region' | 'point';
  readonly vertices: Uint32Array;
}

export interface OpenedModel {
  readonly id: KernelId;
  /** Drawable triangles in source indices, 3 each, faces in file order. */
  readonly triangles: Uint32Array;
  /** Source face of each of them. */
  readonly faceOfTriangle: Uint32Array;
  /** Per source vertex its welded vertex; −1 where it is unused or not finite. */
  readonly welded: Int32Array;
  readonly findings: readonly Finding[];
  readonly components: number;
  readonly boundaryLoops: number;
  readonly eulerCharacteristic: number;
  readonly oriented: boolean;
  readonly closed: boolean;
}

export interface Measured {
  readonly volumeRatio: number;
  readonly edgeRms: number;
  readonly worstStretch: number;
  readonly flippedTriangles: number;
  /** Per source vertex: mean of l/l₀ − 1 over its edges. */
  readonly stretch: Float32Array;
}

/** Models: what every other part stands on. */
export interface ModelKernel {
  /** Welds, triangulates, checks. Codes: no-vertices, no-faces, no-usable-faces, zero-size. */
  openModel(args: {
    positions: Float64Array;
    faceOffsets: Uint32Array;
    faceVertices: Uint32Array;
  }): OpenedModel;

  /** What moving a model's vertices to `positions` did to it. */
  measure(args: { model: KernelId; positions: Float64Array }): Measured;

  /** Frees what is held. Unknown ids are ignored, so it is safe in any clean-up. */
  release(args: { id: KernelId }): void;
}
