// What the floors above know of hair in the viewport: plain data, model space.

import type { Strands } from '../../core/strands';
import type { Vec3 } from '../types';

export interface HairOptions {
  readonly show: boolean;
  /** `kajiya-kay`: the thesis's pictures; `natural`: two highlights, light through the hair, colour by depth. */
  readonly shading: 'natural' | 'kajiya-kay';
  /** Strands are drawn this much thicker: full count / preview count while few stand for many. At most 3 counts. */
  readonly widthScale: number;
}

/** A curve a person has drawn or may draw along. */
export interface StyleCurve {
  readonly id: string;
  readonly points: readonly Vec3[];
  readonly kind: 'stream' | 'parting' | 'spine' | 'section' | 'profile' | 'hint';
  readonly selected: boolean;
}

export interface CurveHit {
  readonly id: string;
  /** The control point under the pointer; null on the line between two. */
  readonly point: number | null;
  /** The line from point `segment` to the next is nearest. */
  readonly segment: number;
}

/** Short arrows: 3 numbers each, same length. */
export interface FieldSample {
  readonly places: Float32Array;
  /** Arrow from tail to tip, model units. */
  readonly vectors: Float32Array;
}

export interface Box {
  readonly low: Vec3;
  readonly high: Vec3;
}

export interface SupportSurface {
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
}

/** The hair workspace's part of the viewport. */
export interface HairPort {
  /** Strands in the shown model's space (or alone); null takes them away. Their look comes with them. */
  setHair(strands: Strands | null): void;
  setHairOptions(options: Partial<HairOptions>): void;
  /** The first so many (0..1) are drawn, thicker; null: as fast as the machine allows while moving, all at rest. */
  setStrandShare(share: number | null): void;
  setCurves(curves: readonly StyleCurve[]): void;
  /** CSS pixels from the viewport's top left corner; control points win over lines. */
  pickCurve(x: number, y: number): CurveHit | null;
  setField(field: FieldSample | null): void;
  /** What the field was asked for, drawn apart from it. */
  setConstraints(constraints: FieldSample | null): void;
  setVolume(box: Box | null): void;
  setSupport(surface: SupportSurface | null): void;
}
