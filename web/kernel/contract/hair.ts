import type { Finding } from '../../core/errors';
import type { KernelId } from './model';

export interface OpenedHair {
  readonly id: KernelId;
  /** Nodes of the field per axis. */
  readonly grid: readonly [number, number, number];
  /** Corners of the volume that hair may fill, model space. */
  readonly low: readonly [number, number, number];
  readonly high: readonly [number, number, number];
  /** What the sizes of hair are measured by, model units. */
  readonly headHeight: number;
  readonly seconds: { readonly prepare: number };
  readonly peakBytes: number;
}

/** Style primitives in model space; all lines are 3 numbers a point. */
export interface HairStyle {
  readonly streams: readonly { readonly points: Float64Array; readonly fade: boolean }[];
  readonly partings: readonly {
    readonly points: Float64Array;
    /** Degrees, at the two ends. */
    readonly tilt: readonly [number, number];
    /** In grid steps. */
    readonly sigma: number;
    readonly height: number;
  }[];
  readonly ponytails: readonly {
    readonly spine: Float64Array;
    readonly section: Float64Array;
    /** At most two. */
    readonly profiles: readonly Float64Array[];
    readonly tightness: number;
  }[];
}

export interface StyledHair {
  /** Of style and scalp together. */
  readonly constraints: number;
  /** Their examples number the primitives through: streams, partings, ponytails. */
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly update: number; readonly field: number };
}

/** How strands grow and what detail they get; what is left out has the kernel's default. Lengths in model units. */
export interface HairOptions {
  /** A whole number. */
  readonly seed?: number;
  /** In grid steps. */
  readonly step?: number;
  readonly length?: number;
  readonly lengthVariation?: number;
  /** Factor of the length per source vertex. */
  readonly lengthMap?: Float32Array;
  readonly volume?: number;
  readonly clump?: number;
  readonly curl?: number;
  readonly curlLength?: number;
  readonly frizz?: number;
  readonly flyaways?: number;
}

export interface GrownHair {
  /** Strands + 1, counted in points. */
  readonly offsets: Uint32Array;
  /** 3 per point, root first, relative to `origin`. */
  readonly points: Float32Array;
  /** 3 numbers, model space. */
  readonly origin: Float64Array;
  /** 2 per strand. */
  readonly rootUvs: Float32Array;
  /** Per strand the clump it belongs to. */
  readonly groups: Uint32Array;
  /** Points deeper in the head than 0.5 % of its height. */
  readonly insideHead: number;
  /** Strands of fewer than three segments. */
  readonly shortStrands: number;
  /** Per ponytail: strands of its region, and those of them that pass through its first cross-section. */
  readonly reached: readonly number[];
  readonly gathered: readonly number[];
  readonly seconds: { readonly grow: number };
  readonly peakBytes: number;
}

/** A picture of the field: every so many nodes, model space, single precision. */
export interface FieldVectors {
  readonly places: Float32Array;
  readonly vectors: Float32Array;
}

/** Hair: a head prepared once, styled and grown as often as asked. */
export interface HairKernel {
  /**
   * Prepares a head for hair: once per head, scalp and resolution. Reports progress, can be cancelled.
   * Codes: scalp-empty, scalp-vertex, bad-resolution, head-empty.
   */
  openHair(args: {
    model: KernelId;
    /** Source vertices that hair grows on. */
    scalp: Uint32Array;
    /** Field nodes along the longest side of the volume, 16..96. */
    resolution: number;
    up: 'y' | 'z';
  }): OpenedHair;

  /** Solves the field of a style; the cost follows what changed since the last one. */
  styleHair(args: { hair: KernelId; style: HairStyle }): StyledHair;

  /**
   * Strands [from, from + count) of the last style: the same whatever range they are grown in, so a preview is a
   * prefix. Reports progress, can be cancelled. Codes: too-many-strands, bad-option.
   */
  growHair(args: { hair: KernelId; from: number; count: number; options: HairOptions }): GrownHair;

  /** The field of the last style, at every `stride`-th node along each axis. */
  hairField(args: { hair: KernelId; stride: number }): FieldVectors;

  /** What the field of the last style was asked for: vectors of the style, then those of the scalp, a grid step long. */
  hairConstraints(args: { hair: KernelId }): FieldVectors;
}
