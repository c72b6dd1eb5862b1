// What the floors above know of the overlays: plain data in model space, and one port for each kind.

import type { ContourLines } from '../../kernel/contract/contour';
import type { Tint } from '../palette';
import type { Vec3 } from '../values';

export interface PointMarker {
  readonly id: string;
  readonly position: Vec3;
  readonly visible: boolean;
  readonly selected: boolean;
}

/** Points that can be taken hold of. */
export interface MarkersPort {
  setMarkers(markers: readonly PointMarker[]): void;
  /** CSS pixels from the viewport's top left corner. */
  pickMarker(x: number, y: number): string | null;
}

/** A closed line on the surface. */
export interface LoopLine {
  /** 3 per point, model space; the last is joined to the first. */
  readonly points: Float64Array;
  /** White where left out. */
  readonly tint?: Tint;
  /** Under the pointer, or picked: wider. */
  readonly strong: boolean;
}

export interface LoopsPort {
  setLoops(loops: readonly LoopLine[]): void;
}

/** Lines of equal value of a field on the surface. */
export interface LevelLines {
  /** In [0, 1] per source vertex. */
  readonly values: Float32Array;
  /** Lines at whole multiples of 1 / steps, ends left out. */
  readonly steps: number;
}

export interface LevelsPort {
  setLevels(lines: LevelLines | null): void;
}

/** A line with its control points. */
export interface ControlLine {
  readonly id: string;
  readonly points: readonly Vec3[];
  readonly tint: 'blue' | 'green' | 'yellow' | 'violet' | 'cyan' | 'coral';
  readonly selected: boolean;
  /** A mere line: its points are not shown and it cannot be picked. */
  readonly plain?: boolean;
  /** Drawn in place of straight pieces: from each control point to the next as many points. */
  readonly smooth?: readonly Vec3[];
  /** The point that is taken up; none where left out. */
  readonly chosen?: number | undefined;
  /** Points where it hangs on another line. */
  readonly joints?: readonly number[];
  /** What is under the pointer: one of its points, or the line. */
  readonly under?: number | 'line' | undefined;
}

export interface ControlHit {
  readonly id: string;
  /** The control point under the pointer; null on the line between two. */
  readonly point: number | null;
  /** The line from point `segment` to the next is nearest. */
  readonly segment: number;
}

export interface ControlLinesPort {
  setLines(lines: readonly ControlLine[]): void;
  /** CSS pixels from the viewport's top left corner; control points win over lines. */
  pickLine(x: number, y: number): ControlHit | null;
}

/** Lines on the surface as a pen would draw them: suggestive ones thin. */
export type PenDrawing = Pick<
  ContourLines,
  'points' | 'offsets' | 'corners' | 'weights' | 'suggestive' | 'closed'
>;

/** The line in hand: where it runs, its ends, and how far a pull of it reaches. */
export interface PenHold {
  readonly line: readonly Vec3[];
  readonly ring: { readonly centre: Vec3; readonly radius: number };
  /** What of it is under the pointer. */
  readonly lit: PenPart | null;
}

export type PenPart = 'start' | 'end' | 'ring' | 'line';

/** A line under the pointer. */
export interface PenHit {
  readonly line: number;
  /** Between point `segment` of the line and the next, `t` of the way. */
  readonly segment: number;
  readonly t: number;
  readonly point: Vec3;
  /** CSS pixels. */
  readonly distance: number;
}

/** While it is in the picture the model is drawn as paper, with pen lines on it. */
export interface PenPort {
  setDrawing(drawing: PenDrawing | null): void;
  /** Lets the lines go along with the surface. @param positions  3 per source vertex; `null`: as they were drawn */
  carry(positions: Float64Array | null): void;
  /** The line under the pointer. */
  light(line: number | null): void;
  hold(hold: PenHold | null): void;
  /** Tints what would move. @param weights  in [0, 1] per source vertex */
  tint(weights: Float32Array | null): void;
  /** CSS pixels from the viewport's top left corner. The nearest first; those that something hides, too. */
  pickLines(x: number, y: number): readonly PenHit[];
  pickHold(x: number, y: number): PenPart | null;
}

/** Short arrows: 3 numbers each, same length. */
export interface FieldSample {
  readonly places: Float32Array;
  /** Arrow from tail to tip, model units. */
  readonly vectors: Float32Array;
}

export interface FieldPort {
  setField(field: FieldSample | null): void;
  /** What the field was asked for, drawn apart from it. */
  setConstraints(constraints: FieldSample | null): void;
}

export interface Box {
  readonly low: Vec3;
  readonly high: Vec3;
}

export interface BoxPort {
  setVolume(box: Box | null): void;
}

export interface SupportSurface {
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
}

export interface SupportPort {
  setSupport(surface: SupportSurface | null): void;
}

/** Another model, drawn where it is. */
export interface Companion {
  readonly id: string;
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
  /** What is worn, or what was there before: one looks through that. */
  readonly look: 'cloth' | 'ghost';
  /** Of which of a few colours cloth is. */
  readonly dye?: number;
  /** Cloth coloured by a value per vertex, with the perceptual map. */
  readonly heat?: { readonly values: Float32Array; readonly range: readonly [number, number] } | undefined;
}

export interface CompanionsPort {
  setCompanions(companions: readonly Companion[]): void;
}
