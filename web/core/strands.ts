// Hair as polylines: what the kernel grows, the view draws and exporters write.

import type { Model } from './model';

export interface Strands {
  /** Strands + 1 offsets into points (counted in points, not numbers). */
  readonly offsets: Uint32Array;
  /** 3 per point, root first, head units, relative to `origin`. */
  readonly points: Float32Array;
  /** Added to every point; keeps single precision good far from the origin. */
  readonly origin: readonly [number, number, number];
  /** Per strand: texture-like coordinates of the root on the scalp, in [0, 1]. */
  readonly rootUvs?: Float32Array;
  /** Per strand: number of its clump, or of its group in an imported file. */
  readonly groups?: Uint32Array;
  /** How it looks; lengths in head units, colours sRGB hex. */
  readonly look: StrandLook;
}

export interface StrandLook {
  /** Diameter at the root. */
  readonly thickness: number;
  /** Diameter at the tip, as a share of that at the root. */
  readonly taper: number;
  /** `#rrggbb` */
  readonly color: string;
  /** How much strands differ in colour, 0..1. */
  readonly colorVariation: number;
}

/** A groom to export or show: the hair with the head it grows on, in the same space. */
export interface Groom {
  readonly name: string;
  readonly strands: Strands;
  readonly head?: Model;
  /** Strand indices that lead the others; absent: every strand is its own. */
  readonly guides?: Uint32Array;
}

export const strandCount = (strands: Strands): number => Math.max(0, strands.offsets.length - 1);
