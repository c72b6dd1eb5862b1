import type { Finding } from '../../core/errors';
import type { KernelId } from './model';

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
  readonly id: KernelId;
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

/** Merging: cut and factored once per set of boundaries. */
export interface MergeKernel {
  /** Cuts both models along their boundaries and factors: once per set of boundaries. Reports progress, can be cancelled. */
  prepareMerge(args: {
    source: KernelId;
    target: KernelId;
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
  merge(args: { merge: KernelId; keys: readonly Uint32Array[]; settle?: boolean }): Merged;

  /** The plane maps that an optimal boundary is sought in. */
  mapRegions(args: { source: KernelId; target: KernelId; regions: PaintedRegions }): RegionMaps;

  /** Closed paths around painted vertices, the painted side to their left. */
  loopsAround(args: { model: KernelId; vertices: Uint32Array }): readonly Uint32Array[];
}
