import type { Finding } from '../../core/errors';
import type { KernelId } from './model';

export interface PreparedSketch {
  readonly id: KernelId;
  readonly seconds: { readonly surface: number };
  readonly peakBytes: number;
}

export interface SketchOptions {
  /** `automatic`: a skeleton, on open sheets a surface curve. */
  readonly kind?: 'automatic' | 'skeleton' | 'surface';
  /** Control points: so many that the curve stays within this of the stroke, in CSS pixels. */
  readonly fit?: number;
}

export interface SketchedCurve {
  readonly kind: 'skeleton' | 'surface';
  /** 3 a control point, model space. */
  readonly points: Float64Array;
  /** Local radius at each. */
  readonly radius: Float64Array;
  /** What the stroke met, for `curveRegion` of the same model; no use to anyone else. */
  readonly hits: Uint32Array;
  /** `stroke-overshoots`, `stroke-crosses-gap`, `open-sheet`. */
  readonly warnings: readonly Finding[];
  readonly seconds: number;
}

export interface RegionOptions {
  /** As `sketchCurve` answered; else measured. */
  readonly radius?: Float64Array;
  /** As `sketchCurve` answered; else what lies nearest to the curve. */
  readonly hits?: Uint32Array;
  /** Reach in local radii. */
  readonly kappa?: number;
  /** `planes`: between two infinite planes, the reference. */
  readonly method?: 'local' | 'planes';
}

/** Source vertices, ascending; those in no list stay at rest. */
export interface CurveRegion {
  readonly vertices: Uint32Array;
  readonly startSide: Uint32Array;
  readonly endSide: Uint32Array;
  /** What remains and touches both ends: to be blended between them. */
  readonly between: Uint32Array;
  readonly radius: Float64Array;
  readonly seconds: number;
}

export interface ProposedCurves {
  readonly curves: readonly { readonly points: Float64Array; readonly radius: Float64Array }[];
  /** The child's first point belongs to the parent's curve at parameter `at`, 0 to 1. */
  readonly links: readonly { readonly child: number; readonly parent: number; readonly at: number }[];
}

export interface LineWeights {
  /** Source vertices that move with the line, ascending. */
  readonly vertices: Uint32Array;
  /** In (0, 1] each. */
  readonly weights: Float64Array;
  /** Of each the place on the line that it follows: share of its length. */
  readonly along: Float64Array;
}

/** Drawing curves on a model: what a stroke means, and what of the model follows it. */
export interface SketchKernel {
  /** Once per mesh: who neighbours whom, and what a ray meets. */
  prepareSketch(args: { model: KernelId }): PreparedSketch;

  /**
   * The curve that a stroke means. Codes: stroke-off-model, stroke-too-short, eye-inside-model, bad-stroke.
   * A ray for each place of the stroke, model space.
   */
  sketchCurve(args: {
    sketch: KernelId;
    /** 2 a place, CSS pixels. */
    pixels: Float64Array;
    origins: Float64Array;
    directions: Float64Array;
    options?: SketchOptions;
  }): SketchedCurve;

  /** What follows a curve through `points`; no vertices where none is near. Codes: curve-points, curve-radius, curve-reach, curve-hits. */
  curveRegion(args: { sketch: KernelId; points: Float64Array; options?: RegionOptions }): CurveRegion;

  /** Skeleton curves of a model with limbs, to begin with. Codes: no-limbs. */
  proposeCurves(args: { sketch: KernelId }): ProposedCurves;

  /** How far vertices follow a line on the surface that is pulled; `others` stay. Codes: line-too-short, line-radius. */
  lineWeights(args: {
    sketch: KernelId;
    line: Float64Array;
    others: readonly Float64Array[];
    /** Along the surface; absent: 0.13 of the largest extent. */
    radius?: number;
  }): LineWeights;
}
