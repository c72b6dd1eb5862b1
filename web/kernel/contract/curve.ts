import type { Finding } from '../../core/errors';
import type { KernelId } from './model';

export interface CurveSpec {
  /** 3 per control point, source space. */
  readonly rest: Float64Array;
  /** A limb takes its region along; a contour pulls the surface around it. */
  readonly role: 'limb' | 'contour';
  readonly rigid: Uint32Array;
  /** Source vertices that follow it; `null`: found. */
  readonly region: Uint32Array | null;
  /** `null`: the end with more of the model beyond it. */
  readonly anchor: 'start' | 'end' | null;
  /** Of a contour: how far its pull goes along the surface, source units; 0: a share of the model's size. */
  readonly reach: number;
  /** Of a contour: lines beside it that stay, 3 per control point. */
  readonly held: readonly Float64Array[];
}

/** Curves by their numbers. */
export interface CurveLink {
  readonly child: number;
  readonly parent: number;
  readonly at: number;
}

export interface CurveOptions {
  readonly blending: 'ownership' | 'geodesic' | 'gaussian';
  readonly encoding: 'kernel' | 'slabs';
  readonly guard: 'symmetric' | 'thesis' | 'none';
}

/** How one curve is posed; empty lists: as at rest. */
export interface CurvePosture {
  /** 3 per control point; a linked curve's in the frame of its parent at rest. */
  readonly points: Float64Array;
  /** (x, y, z, w), or empty. */
  readonly base: Float64Array;
  /** Degrees, one per control point. */
  readonly twist: Float64Array;
  /** 2 per control point. */
  readonly scale: Float64Array;
}

/** Folds begin where `bend` is 1; the guard turns planes by up to `tilt` degrees. */
export interface CurveStrain {
  readonly bend: number;
  readonly tilt: number;
}

export interface PreparedCurves {
  readonly id: KernelId;
  /** Per curve. */
  readonly curves: readonly {
    /** Source vertices that it moves by itself, ascending. */
    readonly region: Uint32Array;
    readonly anchor: 'start' | 'end';
    /** Of the limb, at each control point. */
    readonly radii: Float64Array;
  }[];
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly regions: number; readonly encode: number };
  readonly peakBytes: number;
}

export interface PosedCurves extends CurveStrain {
  /** 3 per source vertex. */
  readonly positions: Float64Array;
  readonly seconds: { readonly pose: number };
}

/** What a vertex shader needs once: 4 curves, rows and weights a source vertex, and the place that positions are told from. */
export interface CurveAttributes {
  /** Their numbers. */
  readonly curves: Uint16Array;
  /** In [0, 255]. */
  readonly rows: Float32Array;
  /** 0 where there is none; what is left to 1 rests. */
  readonly weights: Float32Array;
  readonly centre: readonly [number, number, number];
  /** 12 a row at rest: origin in model space, then the axes u, v, w. What bones are made from. */
  readonly frames: Float64Array;
  /**
   * 9 a row at rest, what normals are turned by: place C less the centre, g along the curve in rows per length, curvature κ.
   * A vertex at x changes its row with its place by g / (1 − κ·(x − C)), the divisor at least 0.05.
   */
  readonly slopes: Float64Array;
}

/** What it needs for each pose: 5 texels of 4 numbers a row, 256 rows a curve. */
export interface CurveTable extends CurveStrain {
  readonly texels: Float32Array;
}

/** Curves on a model (Blanco 2007): regions and places along them once, then one pose after another. */
export interface CurveKernel {
  /** Finds regions and encodes. Reports progress, can be cancelled. */
  prepareCurves(args: {
    model: KernelId;
    curves: readonly CurveSpec[];
    links: readonly CurveLink[];
    options: CurveOptions;
  }): PreparedCurves;

  /** Positions in a pose. The fast half. */
  poseCurves(args: { curves: KernelId; postures: readonly CurvePosture[] }): PosedCurves;

  /** What the shader draws a prepared model's poses from. */
  curveAttributes(args: { curves: KernelId }): CurveAttributes;

  /** A pose for the shader: no vertex is touched. */
  curveTable(args: { curves: KernelId; postures: readonly CurvePosture[] }): CurveTable;

  /** Unit normals of a pose from those at rest, 3 per source vertex. */
  curveNormals(args: { curves: KernelId; postures: readonly CurvePosture[]; normals: Float64Array }): {
    normals: Float64Array;
  };

  /** How far a drag may go in a straight line before the surface folds: a share from 0 to 1. */
  curveDragLimit(args: { curves: KernelId; from: readonly CurvePosture[]; to: readonly CurvePosture[] }): {
    share: number;
  };

  /** What each curve takes over from its parent: column-major 4×4, one after the other, from its own space to that of the pose. */
  curveParents(args: { curves: KernelId; postures: readonly CurvePosture[] }): { matrices: Float64Array };

  /** Control points of a chain whose end reaches for a target, segments as long as before; `held` ones stay. */
  reachCurve(args: {
    points: Float64Array;
    /** Number of the point that is dragged. */
    end: number;
    target: readonly [number, number, number];
    held: Uint32Array;
  }): { points: Float64Array; reached: boolean };

  /** Triangles that meet others without a common vertex, counted exactly, at `positions` of a model's source vertices. */
  selfIntersections(args: { model: KernelId; positions: Float64Array }): {
    pairs: number;
    /** Source faces of all of them, ascending. */
    faces: Uint32Array;
  };
}
