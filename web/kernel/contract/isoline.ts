import type { Finding } from '../../core/errors';
import type { HandleSpec, KernelId } from './model';

export interface IsolineOptions {
  readonly basis?: 'quadratic' | 'hats';
  /** Of each handle. */
  readonly controls?: number;
  readonly local?: 'patches' | 'isolines' | 'positions';
  readonly sampledTriangles?: number;
  readonly scaleDetails?: boolean;
  /** Full passes on release, 1 to 3. */
  readonly settlePasses?: number;
}

/** Most bytes at one time, beside the model itself. */
export interface IsolineMemory {
  readonly model: number;
  readonly session: number;
  readonly settle: number;
}

export interface PreparedIsolineModel {
  readonly id: KernelId;
  /** Of the surface that fields and energies are computed on. */
  readonly vertices: number;
  readonly proxy: boolean;
  readonly smoothed: boolean;
  readonly seconds: { readonly surface: number };
  readonly peakBytes: number;
}

export interface PreparedIsolines {
  readonly id: KernelId;
  readonly unknowns: number;
  /** Placed by the kernel where flat isolines leave no rotation. */
  readonly freeHandles: number;
  /** Whether settling is a full pass, or turns details only. */
  readonly settlesFully: boolean;
  /** Sets of controls, one where two handles mirror each other. */
  readonly sets: number;
  readonly single: boolean;
  readonly basis: 'quadratic' | 'hats';
  /** Of each set. */
  readonly controls: number;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly fields: number; readonly reduce: number };
  readonly peakBytes: number;
}

/** What one frame of a drag did. */
export interface IsolineFrame {
  /** 12 numbers a control: rows of [D | t], x′ = x + Σ weight (D x + t), model space. */
  readonly offsets: Float64Array;
  readonly iterations: number;
  /** Of the sampled points in the last iteration, in diagonals. */
  readonly change: number;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly perIteration: number };
}

export interface IsolinePose extends Omit<IsolineFrame, 'seconds'> {
  /** 3 per source vertex. */
  readonly positions: Float64Array;
  readonly seconds: { readonly perIteration: number; readonly apply: number; readonly settle: number };
}

/** What a blend on the graphics card needs once: per source vertex, vertex by vertex. */
export interface IsolineFields {
  /** A value in [0, 1] per set. */
  readonly fields: Float32Array;
  /** 3 numbers per set, 1 per model unit. */
  readonly gradients: Float32Array;
  /** 1 for vertices that stay at rest: of no triangle, or of a piece that no handle holds. */
  readonly still: Uint8Array;
}

/** Deforming in the space of the handles' isolines (001): a frame costs the same whatever the size of the model. */
export interface IsolineKernel {
  /** Memory that preparing would take, stated before it starts. */
  estimateIsolines(args: { model: KernelId; handles: number; options: IsolineOptions }): IsolineMemory;

  /** Once per mesh. Reports progress, can be cancelled. */
  prepareIsolineModel(args: { model: KernelId }): PreparedIsolineModel;

  /** Once per set of handles. Reports progress, can be cancelled. */
  prepareIsolines(args: {
    isolineModel: KernelId;
    /** Source vertices that may move; handles are added to it. */
    roi: Uint32Array;
    handles: readonly HandleSpec[];
    options: IsolineOptions;
  }): PreparedIsolines;

  /**
   * One frame of a drag, from where the last one ended. `targets` holds one column-major 4×4 per handle, end to end, from
   * the rest pose; `solves` at most so many iterations, 0 as the options say.
   */
  dragIsolines(args: { isolines: KernelId; targets: Float64Array; solves?: number }): IsolineFrame;

  /**
   * The result for these targets, from the rest pose and iterated to its end, whatever was dragged before; `settle`: with what
   * the reduced space leaves out. Reports progress, can be cancelled.
   */
  poseIsolines(args: { isolines: KernelId; targets: Float64Array; settle: boolean }): IsolinePose;

  isolineFields(args: { isolines: KernelId }): IsolineFields;

  /** To show: a handle's harmonic field or its rigidity per source vertex; `handle: -1` with `rigidity`: combined. */
  isolineField(args: { isolines: KernelId; handle: number; what: 'field' | 'rigidity' }): {
    readonly values: Float32Array;
  };

  /** To show: isolines of a handle's field at `count` equal steps. Curve `i` has points `offsets[i]` to `offsets[i + 1]`, 3 numbers each. */
  isolineCurves(args: { isolines: KernelId; handle: number; count: number }): {
    readonly points: Float64Array;
    readonly offsets: Uint32Array;
  };
}
