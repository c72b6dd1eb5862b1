import type { Finding } from '../../core/errors';
import type { KernelId } from './model';

export interface PreparedTransfer {
  readonly id: KernelId;
  /** Rows of the system that a pose is fitted by: control transformations by four. */
  readonly unknowns: number;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly fields: number; readonly reduce: number };
  readonly peakBytes: number;
}

export interface Transferred {
  /** 3 per source vertex of the target. */
  readonly positions: Float64Array;
  readonly iterations: number;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly perIteration: number; readonly solve: number };
}

/** Deformation transfer (Isolines sec. 6): fields of both models once per set of handles, then one pose after another. */
export interface TransferKernel {
  /**
   * Computes the fields of the handles on both models and factors: once per set of handles. Reports progress, can be
   * cancelled.
   */
  prepareTransfer(args: {
    /** The model that is posed, at rest. */
    source: KernelId;
    /** Source vertices of each handle; none is empty. */
    sourceHandles: readonly Uint32Array[];
    target: KernelId;
    /** In the order of the others. */
    targetHandles: readonly Uint32Array[];
  }): PreparedTransfer;

  /** The target in a pose of the source: 3 numbers per source vertex of that. The fast half. */
  transfer(args: {
    transfer: KernelId;
    pose: Float64Array;
    /** 0: at rest, 1: the whole pose. */
    strength: number;
    /** Takes over stretch and shear as well; else triangles only turn. */
    keepStretch: boolean;
  }): Transferred;
}
