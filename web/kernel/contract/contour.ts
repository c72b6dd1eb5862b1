import type { KernelId } from './model';

export interface PreparedContours {
  readonly id: KernelId;
  readonly seconds: { readonly curvature: number };
  readonly peakBytes: number;
}

export interface ContourView {
  readonly perspective: boolean;
  /** The eye in model space; of a parallel view the direction towards it. */
  readonly eye: readonly [number, number, number];
}

export interface ContourOptions {
  /** Suggestive contours as well. */
  readonly suggestive?: boolean;
  /** How strong a suggestive line must be somewhere, in shares of what is usual in the view; 0 keeps all. */
  readonly strength?: number;
  /** Shortest line, in shares of half the model's diagonal. */
  readonly shortest?: number;
  /** Lines are split where they turn by more than this, in degrees. */
  readonly corner?: number;
}

export interface ContourLines {
  /** Line `i` has points `offsets[i]` to `offsets[i + 1]`, 3 numbers each, model space; contours first. */
  readonly points: Float64Array;
  readonly offsets: Uint32Array;
  /** Where each point is on the surface, whatever becomes of that: 3 source vertices, and 3 weights that sum to 1. */
  readonly corners: Uint32Array;
  readonly weights: Float32Array;
  /** 1 for a suggestive contour. */
  readonly suggestive: Uint8Array;
  /** 1 where the last point goes on to the first. */
  readonly closed: Uint8Array;
  readonly strength: Float64Array;
  readonly seconds: number;
}

/** Contours and suggestive contours: curvature once per mesh, then one view after another. */
export interface ContourKernel {
  /** @param sweeps of smoothing the curvature, 0 to 200. Reports progress, can be cancelled. */
  prepareContours(args: { model: KernelId; sweeps?: number }): PreparedContours;

  /** The lines of a view, hidden ones too. A newer call on the same id makes this one fail with view-replaced. Codes: bad-view. */
  contourLines(args: { contours: KernelId; view: ContourView; options?: ContourOptions }): ContourLines;
}
