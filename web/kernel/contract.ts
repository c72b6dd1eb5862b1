// The bridge: what can be asked of the kernel, of what shape, and how it can fail. The one file both
// sides import; client methods, messages and handlers are all derived from `Kernel`.

import type { ContourKernel } from './contract/contour';
import type { CurveKernel } from './contract/curve';
import type { DeformKernel } from './contract/deform';
import type { HairKernel } from './contract/hair';
import type { IsolineKernel } from './contract/isoline';
import type { GrowingSkins, MatchKernel } from './contract/match';
import type { MergeKernel } from './contract/merge';
import type { KernelId, ModelKernel } from './contract/model';
import type { SketchKernel } from './contract/sketch';
import type { TransferKernel } from './contract/transfer';
import type { WearKernel } from './contract/wear';

export type { KernelId };
/** What can be seen of work under way. */
export type Look = GrowingSkins;

/** One line per wing: the registry of the bridge. */
export interface Kernel
  extends ModelKernel,
    DeformKernel,
    IsolineKernel,
    MergeKernel,
    HairKernel,
    TransferKernel,
    MatchKernel,
    WearKernel,
    CurveKernel,
    SketchKernel,
    ContourKernel {}

export type Method = keyof Kernel;
export type Args<M extends Method> = Parameters<Kernel[M]>[0];
export type Result<M extends Method> = ReturnType<Kernel[M]>;

export interface CallOptions {
  readonly signal?: AbortSignal;
  /** In [0, 1], at most every 50 ms. */
  readonly onProgress?: (fraction: number) => void;
  /** Sees what is being made before it is done, from the methods that have something to see. */
  readonly onLook?: (look: Look) => void;
  /** Buffers of the arguments that may be moved instead of copied; they are empty afterwards. */
  readonly moved?: Transferable[];
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
