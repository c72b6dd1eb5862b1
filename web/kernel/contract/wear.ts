import type { Finding } from '../../core/errors';
import type { KernelId } from './model';

/** Shapes of one connectivity. */
export interface Skins {
  /** 3 per triangle. */
  readonly triangles: Uint32Array;
  /** Of each: 3 per vertex. */
  readonly positions: readonly Float64Array[];
}

/** A part of the skin that takes the shape of one of them. */
export interface PartSpec {
  /** Number of the skin. */
  readonly from: number;
  readonly vertices: Uint32Array;
  /** How far around it the skin goes over, in units of that skin; as suits the part when left out. */
  readonly feather?: number | undefined;
  readonly how: 'paste' | 'low-pass';
}

/** Something to measure on a skin. `value`: what is wanted; left out, it is only measured. */
export type MeasureSpec = { readonly value?: number | undefined } & (
  | { readonly kind: 'height'; readonly up: readonly [number, number, number] }
  | {
      readonly kind: 'section';
      readonly vertex: number;
      readonly normal: readonly [number, number, number];
      readonly hull: boolean;
    }
  | { readonly kind: 'loop'; readonly vertices: Uint32Array; readonly hull: boolean }
  | { readonly kind: 'path'; readonly vertices: Uint32Array }
);

export interface PreparedBlend {
  readonly id: KernelId;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly factor: number };
  readonly peakBytes: number;
}

export interface Blended {
  /** 3 per vertex. */
  readonly positions: Float64Array;
  /** As given, or as the measures ask. */
  readonly weights: Float64Array;
  /** Each measure of the shape: what it is. */
  readonly reached: Float64Array;
  /** Rounds of the search for weights. */
  readonly iterations: number;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly measure: number; readonly blend: number };
}

export interface PreparedDress {
  readonly id: KernelId;
  readonly seconds: { readonly prepare: number };
  readonly peakBytes: number;
}

/** What of a garment lies within the body. */
export interface InsideCount {
  readonly vertices: number;
  readonly faceCentres: number;
}

export interface Dressed {
  /** 3 per source vertex of the garment. */
  readonly positions: Float64Array;
  readonly before: InsideCount;
  readonly after: InsideCount;
  /** Of pushing out. */
  readonly rounds: number;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly dress: number };
}

export interface PreparedThrough {
  readonly id: KernelId;
  /** Vertices of the skin. */
  readonly unknowns: number;
  readonly seconds: { readonly prepare: number };
  readonly peakBytes: number;
}

export interface TransferredThrough {
  /** 3 per source vertex of the target. */
  readonly positions: Float64Array;
  /** Solves. */
  readonly iterations: number;
  readonly seconds: { readonly solve: number };
}

/** Where points lie nearest on a model. */
export interface SurfacePlaces {
  /** Of each: one of the model's drawable triangles. */
  readonly triangles: Int32Array;
  /** Of each: 3 weights of its corners. */
  readonly weights: Float64Array;
}

/** What skins of one connectivity are for (Skins 5): shapes between them, and what is worn on one carried to another, poses given on. */
export interface WearKernel {
  /** Factors what the parts are pasted by: once per set of parts. Codes: empty-part, whole-part, vertex-out-of-range. Reports progress. */
  prepareBlend(args: Skins & { parts: readonly PartSpec[] }): PreparedBlend;

  /**
   * The sum of the skins by weights, then the parts. Wanted measures are of the sum: the weights are first brought to where they
   * come out. The fast half. Codes: no-weights, loop-open, vertex-out-of-range.
   */
  blend(args: { blend: KernelId; weights: Float64Array; measures: readonly MeasureSpec[] }): Blended;

  /** The map between two bodies for a garment: once per garment and pair. Reports progress. Codes: flat-skin, wrong-size. */
  prepareDress(args: {
    garment: KernelId;
    triangles: Uint32Array;
    from: Float64Array;
    to: Float64Array;
    /** What the second skin is of: minded beside it. */
    model?: KernelId | undefined;
  }): PreparedDress;

  /** The garment on the other body, with more or less ease. The fast half. */
  dress(args: { dress: KernelId; offset: number }): Dressed;

  /** Two models and their skins, for poses of the one given to the other: once per pair. Reports progress. Codes: flat-skin, wrong-size. */
  prepareTransferThrough(args: {
    source: KernelId;
    target: KernelId;
    triangles: Uint32Array;
    from: Float64Array;
    to: Float64Array;
  }): PreparedThrough;

  /** The target in a pose of the source. The fast half. Codes: wrong-size, non-finite-position, bad-option. */
  transferThrough(args: {
    transfer: KernelId;
    /** 3 per source vertex of the source. */
    pose: Float64Array;
    strength: number;
    keepStretch: boolean;
  }): TransferredThrough;

  /** The places of a model nearest to points of its space: what is known of the model can be read there. */
  placesOn(args: { model: KernelId; points: Float64Array }): SurfacePlaces;
}
