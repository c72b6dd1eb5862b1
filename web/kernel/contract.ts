// The bridge: what can be asked of the kernel, of what shape, and how it can fail. The one file both
// sides import; client methods, messages and handlers are all derived from `Kernel`.

import type { Finding } from '../core/errors';

/** A model held by the kernel until `release`. Dies with the worker. */
export type ModelId = number & { readonly brand: 'ModelId' };
/** A factored deformation held by the kernel until `release`. Dies with the worker. */
export type DeformId = number & { readonly brand: 'DeformId' };

export interface OpenedModel {
  readonly model: ModelId;
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

export interface DeformHandleSpec {
  readonly kind: 'region' | 'point';
  readonly vertices: Uint32Array;
}

export interface DeformOptions {
  readonly method?: 'implicit' | 'iterative' | 'naive';
  readonly removeShear?: boolean;
  readonly scaleDetails?: boolean;
  readonly iterations?: number;
  readonly coherenceRing?: 1 | 2;
}

export interface PreparedDeform {
  readonly deform: DeformId;
  readonly free: number;
  readonly degenerate: number;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly assemble: number; readonly factor: number };
  readonly peakBytes: number;
}

export interface Deformed {
  /** 3 per source vertex. */
  readonly positions: Float64Array;
  readonly iterations: number;
  readonly seconds: { readonly solve: number; readonly rotate: number; readonly reconstruct: number };
}

export interface Measured {
  readonly volumeRatio: number;
  readonly edgeRms: number;
  readonly worstStretch: number;
  readonly flippedTriangles: number;
  /** Per source vertex: mean of l/l₀ − 1 over its edges. */
  readonly stretch: Float32Array;
}

export interface Kernel {
  /** Welds, triangulates, checks. Codes: no-vertices, no-faces, no-usable-faces, zero-size. */
  openModel(args: {
    positions: Float64Array;
    faceOffsets: Uint32Array;
    faceVertices: Uint32Array;
  }): OpenedModel;

  /** Assembles and factors: the slow half, once per set of handles. Reports progress, can be cancelled. */
  prepareDeform(args: {
    model: ModelId;
    /** Source vertices that may move; handles are added to it. */
    roi: Uint32Array;
    handles: readonly DeformHandleSpec[];
    options: DeformOptions;
  }): PreparedDeform;

  /**
   * Positions once each handle has followed its map from the rest pose: the fast half.
   * `targets` holds one column-major 4×4 per handle, end to end. `settle: false` stops after the first solve.
   */
  deform(args: { deform: DeformId; targets: Float64Array; settle?: boolean }): Deformed;

  /** What moving a model's vertices to `positions` did to it. */
  measure(args: { model: ModelId; positions: Float64Array }): Measured;

  /** Frees a model or a session. Unknown ids are ignored, so it is safe in any clean-up. */
  release(args: { id: ModelId | DeformId }): void;
}

export type Method = keyof Kernel;
export type Args<M extends Method> = Parameters<Kernel[M]>[0];
export type Result<M extends Method> = ReturnType<Kernel[M]>;

export interface CallOptions {
  readonly signal?: AbortSignal;
  /** In [0, 1], at most every 50 ms. */
  readonly onProgress?: (fraction: number) => void;
  /** Buffers of the arguments that may be moved instead of copied; they are empty afterwards. */
  readonly transfer?: Transferable[];
}

/**
 * The kernel as everyone above sees it: in the page a client of the worker, in Node the module itself.
 * Rejects with a LissomError: the user's fault (`input`), the numbers' (`solver`), `memory`, `crash` or
 * `cancelled`. Ids of an earlier `epoch` are void: whoever holds some opens its models anew.
 */
export interface KernelPort {
  /** Grows by one each time the worker had to be replaced. */
  readonly epoch: number;
  call<M extends Method>(method: M, args: Args<M>, options?: CallOptions): Promise<Result<M>>;
}
