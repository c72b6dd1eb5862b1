import type { Finding } from '../../core/errors';
import type { HandleSpec, KernelId } from './model';

export interface DeformOptions {
  readonly method?: 'implicit' | 'iterative' | 'naive';
  readonly removeShear?: boolean;
  readonly scaleDetails?: boolean;
  readonly iterations?: number;
  readonly coherenceRing?: 1 | 2;
}

export interface PreparedDeform {
  readonly id: KernelId;
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
  /** Of these targets: `rotation-near-180`, whose examples are handle numbers from 0. */
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly solve: number; readonly rotate: number; readonly reconstruct: number };
}

/** Deforming: factored once per set of handles. */
export interface DeformKernel {
  /** Assembles and factors: the slow half, once per set of handles. Reports progress, can be cancelled. */
  prepareDeform(args: {
    model: KernelId;
    /** Source vertices that may move; handles are added to it. */
    roi: Uint32Array;
    handles: readonly HandleSpec[];
    options: DeformOptions;
  }): PreparedDeform;

  /**
   * Positions once each handle has followed its map from the rest pose: the fast half.
   * `targets` holds one column-major 4×4 per handle, end to end. `settle: false` stops after the first solve.
   */
  deform(args: { deform: KernelId; targets: Float64Array; settle?: boolean }): Deformed;
}
