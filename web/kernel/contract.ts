// The bridge: what can be asked of the kernel, of what shape, and how it can fail. The one file both
// sides import; client methods, messages and handlers are all derived from `Kernel`.

import type { Finding } from '../core/errors';

/** A model held by the kernel until `release`. Dies with the worker. */
export type ModelId = number & { readonly brand: 'ModelId' };
/** A factored deformation held by the kernel until `release`. Dies with the worker. */
export type DeformId = number & { readonly brand: 'DeformId' };
/** Two models factored for merging, held by the kernel until `release`. Dies with the worker. */
export type MergeId = number & { readonly brand: 'MergeId' };
/** A head prepared for hair, with its style, held by the kernel until `release`. Dies with the worker. */
export type HairId = number & { readonly brand: 'HairId' };

export interface OpenedModel {
  readonly model: ModelId;
  /** Drawable triangles in source indices, 3 each, faces in file order. */
  readonly triangles: Uint32Array;
  /** Source face of each of them. */
  readonly faceOfTriangle: Uint32Array;
  /** Per source vertex its welded vertex; −1 where it is unused or not finite. */
  readonly welded: Int32Array;
  readonly findings: readonly Finding[];
  readonly components: number;
  readonly boundaryLoops: number;
  readonly eulerCharacteristic: number;
  readonly oriented: boolean;
  readonly closed: boolean;
}

export interface DeformHandleSpec {
  readonly kind: 'region' | 'point';
  readonly vertices: Uint32Array;
}

export interface DeformOptions {
  readonly method?: 'implicit' | 'iterative' | 'naive';
  readonly removeShear?: boolean;
  readonly scaleDetails?: boolean;
  readonly iterations?: number;
  readonly coherenceRing?: 1 | 2;
}

export interface PreparedDeform {
  readonly deform: DeformId;
  readonly free: number;
  readonly degenerate: number;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly assemble: number; readonly factor: number };
  readonly peakBytes: number;
}

export interface Deformed {
  /** 3 per source vertex. */
  readonly positions: Float64Array;
  readonly iterations: number;
  /** Of these targets: `rotation-near-180`, whose examples are handle numbers from 0. */
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly solve: number; readonly rotate: number; readonly reconstruct: number };
}

export interface Measured {
  readonly volumeRatio: number;
  readonly edgeRms: number;
  readonly worstStretch: number;
  readonly flippedTriangles: number;
  /** Per source vertex: mean of l/l₀ − 1 over its edges. */
  readonly stretch: Float32Array;
}

export interface OpenedHair {
  readonly hair: HairId;
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

/** One pair of boundaries to be joined; vertices of the two files. */
export interface MergeBoundarySpec {
  /** Closed by itself, in either direction: along an opening, or a path across the surface. */
  readonly source: Uint32Array;
  readonly target: Uint32Array;
  /** Vertices of the side to keep, where the loop is a path; empty: the side to its left. */
  readonly sourceKeep: Uint32Array;
  readonly targetKeep: Uint32Array;
}

export interface MergeOptions {
  readonly mode?: 'independent' | 'dependent';
  /** Umbrella iterations at the seam. */
  readonly smoothing?: number;
  readonly coherenceRing?: 1 | 2;
  /** Overlapped transition regions: widths along the two surfaces in their own units, and the weight of E_T. */
  readonly transition?: {
    readonly sourceWidth: number;
    readonly targetWidth: number;
    readonly weight?: number;
  };
  /** Column-major 4×4: where the source stands in the target's space; read by `dependent`. */
  readonly pose?: Float64Array;
}

/** How the source's plane map lies on the target's: scaled, turned (degrees, counter-clockwise), then moved. */
export interface MapPlacement {
  readonly shift: readonly [number, number];
  readonly turn: number;
  readonly scale: number;
}

/** Painted vertices for merging along an optimal boundary. */
export interface PaintedRegions {
  readonly sourceRegion: Uint32Array;
  readonly feature: Uint32Array;
  readonly targetRegion: Uint32Array;
  /** Left out: a good one is found. */
  readonly placement?: MapPlacement;
  /** At most so many rounds; 0: the edge of the source region is the boundary. */
  readonly rounds?: number;
}

/** A painted region in the plane. */
export interface PlaneMap {
  /** File vertex of each point. */
  readonly vertices: Uint32Array;
  /** Numbers of points, 3 each, counter-clockwise seen from outside. */
  readonly triangles: Uint32Array;
  /** 2 per point; the area of the map (a ring with its hole filled) is π and its centroid at 0. */
  readonly points: Float64Array;
}

export interface RegionMaps {
  /** The source region without the feature. */
  readonly source: PlaneMap;
  readonly target: PlaneMap;
  /** The one found where none is given. */
  readonly placement: MapPlacement;
}

export interface PreparedMerge {
  readonly merge: MergeId;
  readonly free: number;
  readonly degenerate: number;
  /** Of the optimal boundary: that of the region's edge first, then after each round; empty where loops are given. */
  readonly energies: Float64Array;
  /** The placement used, where the boundary is sought. */
  readonly placement?: MapPlacement;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly assemble: number; readonly factor: number };
  readonly peakBytes: number;
}

/** Places on a file's surface, three vertices and weights each. */
export interface Origins {
  readonly vertices: Uint32Array;
  readonly weights: Float64Array;
}

/** What of one file goes into the merged model. */
export interface MergeContribution {
  /** Per file vertex its number in the result; −1: left out. */
  readonly resultOfVertex: Int32Array;
  /** Polygons that go in whole, ascending. */
  readonly faces: Uint32Array;
  /** 1 for each of them whose corners go in reverse. */
  readonly turned: Uint8Array;
}

/**
 * The merged model in the terms of its two files. Vertices: kept target vertices in file order, kept source vertices in
 * file order, new ones. Faces: whole target polygons, whole source polygons, triangles cut at the seam.
 */
export interface Merged {
  readonly positions: Float64Array;
  readonly target: MergeContribution;
  readonly source: MergeContribution;
  /** Per new vertex: 1 where its origin is in the source file. */
  readonly newFromSource: Uint8Array;
  readonly newOrigins: Origins;
  /** Three a cut triangle. */
  readonly cutVertices: Uint32Array;
  readonly cutFromSource: Uint8Array;
  /** Per cut triangle its polygon in its file. */
  readonly cutFaces: Uint32Array;
  /** Three a cut triangle: vertices of that polygon. */
  readonly cutOrigins: Origins;
  /** Result vertices of each seam. */
  readonly seams: readonly Uint32Array[];
  /** The keys used, found ones included: source, target, source, target … */
  readonly keys: readonly Uint32Array[];
  readonly eulerCharacteristic: number;
  /** Dihedral angles in degrees along the seam (0 is flat), and below which 90 % of all other edges lie. */
  readonly seam: {
    readonly vertices: number;
    readonly medianDihedral: number;
    readonly highDihedral: number;
    readonly maxDihedral: number;
    readonly ownHighDihedral: number;
    readonly leastAngle: number;
  };
  readonly sourceTurned: boolean;
  readonly warnings: readonly Finding[];
  readonly seconds: { readonly solve: number; readonly stitch: number };
}

export interface Kernel {
  /** Welds, triangulates, checks. Codes: no-vertices, no-faces, no-usable-faces, zero-size. */
  openModel(args: {
    positions: Float64Array;
    faceOffsets: Uint32Array;
    faceVertices: Uint32Array;
  }): OpenedModel;

  /** Assembles and factors: the slow half, once per set of handles. Reports progress, can be cancelled. */
  prepareDeform(args: {
    model: ModelId;
    /** Source vertices that may move; handles are added to it. */
    roi: Uint32Array;
    handles: readonly DeformHandleSpec[];
    options: DeformOptions;
  }): PreparedDeform;

  /**
   * Positions once each handle has followed its map from the rest pose: the fast half.
   * `targets` holds one column-major 4×4 per handle, end to end. `settle: false` stops after the first solve.
   */
  deform(args: { deform: DeformId; targets: Float64Array; settle?: boolean }): Deformed;

  /** Cuts both models along their boundaries and factors: once per set of boundaries. Reports progress, can be cancelled. */
  prepareMerge(args: {
    source: ModelId;
    target: ModelId;
    boundaries: readonly MergeBoundarySpec[];
    /** Finds the boundary instead; `boundaries` is empty then, and `merge` takes one empty list of keys. */
    optimalBoundary?: PaintedRegions;
    /** Source vertices that may move (dependent only); empty: all. */
    roi: Uint32Array;
    /** Source vertices held in place (dependent only), each with a column-major 4×4. */
    handles: readonly { readonly vertices: Uint32Array; readonly matrix: Float64Array }[];
    options: MergeOptions;
  }): PreparedMerge;

  /** The merged model for the keys of each pair of boundaries; a pair without any has its best one found. */
  merge(args: { merge: MergeId; keys: readonly Uint32Array[]; settle?: boolean }): Merged;

  /** The plane maps that an optimal boundary is sought in. */
  mapRegions(args: { source: ModelId; target: ModelId; regions: PaintedRegions }): RegionMaps;

  /** Closed paths around painted vertices, the painted side to their left. */
  loopsAround(args: { model: ModelId; vertices: Uint32Array }): readonly Uint32Array[];

  /** What moving a model's vertices to `positions` did to it. */
  measure(args: { model: ModelId; positions: Float64Array }): Measured;

  /**
   * Prepares a head for hair: once per head, scalp and resolution. Reports progress, can be cancelled.
   * Codes: scalp-empty, scalp-vertex, bad-resolution, head-empty.
   */
  openHair(args: {
    model: ModelId;
    /** Source vertices that hair grows on. */
    scalp: Uint32Array;
    /** Field nodes along the longest side of the volume, 16..96. */
    resolution: number;
    up: 'y' | 'z';
  }): OpenedHair;

  /** Solves the field of a style; the cost follows what changed since the last one. */
  styleHair(args: { hair: HairId; style: HairStyle }): StyledHair;

  /**
   * Strands [from, from + count) of the last style: the same whatever range they are grown in, so a preview is a
   * prefix. Reports progress, can be cancelled. Codes: too-many-strands, bad-option.
   */
  growHair(args: { hair: HairId; from: number; count: number; options: HairOptions }): GrownHair;

  /** The field of the last style, at every `stride`-th node along each axis. */
  hairField(args: { hair: HairId; stride: number }): FieldVectors;

  /** What the field of the last style was asked for: vectors of the style, then those of the scalp, a grid step long. */
  hairConstraints(args: { hair: HairId }): FieldVectors;

  /** Frees a model or a session. Unknown ids are ignored, so it is safe in any clean-up. */
  release(args: { id: ModelId | DeformId | MergeId | HairId }): void;
}

export type Method = keyof Kernel;
export type Args<M extends Method> = Parameters<Kernel[M]>[0];
export type Result<M extends Method> = ReturnType<Kernel[M]>;

export interface CallOptions {
  readonly signal?: AbortSignal;
  /** In [0, 1], at most every 50 ms. */
  readonly onProgress?: (fraction: number) => void;
  /** Buffers of the arguments that may be moved instead of copied; they are empty afterwards. */
  readonly transfer?: Transferable[];
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
