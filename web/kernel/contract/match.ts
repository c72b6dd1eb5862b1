import type { Finding } from '../../core/errors';
import type { KernelId } from './model';

/** Skins under way: the same triangles over each model, in the order of the models. */
export interface GrowingSkins {
  readonly triangles: Uint32Array;
  /** Of each model: 3 per vertex, in its space; under way none where it has no skin yet. */
  readonly positions: readonly Float64Array[];
}

/** One model of a match. */
export interface MatchedModel {
  readonly model: KernelId;
  /** 3 per marker, in the model's space; as many for each model. */
  readonly markers: Float64Array;
  /** Source vertices that nothing is fitted to. */
  readonly ignored: Uint32Array;
  /** 3 per place of each marker curve; as many curves for each model. */
  readonly curves: readonly Float64Array[];
  /** Source vertices along sharp edges that were picked. */
  readonly sharp: readonly Uint32Array[];
}

export interface MatchOptions {
  readonly start?: 'automatic' | 'similarity' | 'radial' | undefined;
  readonly first?: 'copy' | 'remesh' | 'wrap' | 'box' | 'sphere' | 'torus' | undefined;
  readonly method?: 'graph' | 'paper' | undefined;
  readonly genus?: number | undefined;
  /** In the source's units; its own mean length when left out. */
  readonly edgeLength?: number | undefined;
  readonly adapt?: number | undefined;
  /** Degrees; none when left out. */
  readonly sharpAngle?: number | undefined;
  /** False: the source with each other model by itself, composed afterwards (Skins 4); else all at once. */
  readonly together?: boolean | undefined;
}

/** What a skin is worth. Distances are shares of its model's bounding box diagonal. */
export interface SkinFigures {
  /** From the skin to its model, back, and what 99 of 100 places of either are nearer than. */
  readonly distance: { readonly mean: number; readonly back: number; readonly p99: number };
  /** Triangles that face the other way than the model does where they lie. */
  readonly flipped: number;
  /** Edges with sharply turned triangles beside them. */
  readonly folds: number;
  /** Triangles that cross another. */
  readonly selfIntersections: number;
  /** Of a model with sharp edges: how many chains of them, how many of these found no edges of the skin, and how far off they lie at most. */
  readonly sharp?: { readonly curves: number; readonly failed: number; readonly error: number };
}

/** Something to know about a match; `model` counts from 0, −1 stands for all. */
export interface MatchWarning extends Omit<Finding, 'model'> {
  readonly model: number;
}

export interface Matched extends GrowingSkins {
  readonly figures: readonly SkinFigures[];
  /** Of each model: how far each vertex lies from it, in shares of its diagonal. */
  readonly residuals: readonly Float32Array[];
  /** Vertices where a skin is poorest, apart from one another, of each model: good places for another marker. */
  readonly poorest: readonly Uint32Array[];
  /** The skins' vertex that each marker is. */
  readonly markerVertices: Uint32Array;
  /** Largest distance of a marker's vertex from its place, in shares of the diagonal. */
  readonly markerError: number;
  readonly iterations: number;
  readonly warnings: readonly MatchWarning[];
  readonly seconds: {
    readonly start: number;
    readonly carry: number;
    readonly fine: number;
    readonly connectivity: number;
    readonly sharp: number;
    readonly report: number;
  };
  readonly peakBytes: number;
}

/** Skins of one connectivity over several models (Skins), and where places of one lie on another. */
export interface MatchKernel {
  /**
   * Matches models; the first is the source. Reports progress, can be cancelled, and shows the skins as they grow.
   * Codes: marker-count, model-count, non-finite-marker, bad-option, flat-model.
   */
  match(args: { models: readonly MatchedModel[]; options: MatchOptions }): Matched;

  /** Where places near one skin lie on another of the same triangles. @returns 3 numbers per place */
  carryPlaces(args: {
    from: Float64Array;
    to: Float64Array;
    triangles: Uint32Array;
    places: Float64Array;
  }): Float64Array;

  /**
   * A guess of where a place of one model belongs on another: laid on it by the markers so far, then the nearest place that
   * faces alike.
   * @param markers  3 per marker, as many on both models; none: the models as they lie, brought to one size
   */
  guessPlace(args: {
    from: KernelId;
    to: KernelId;
    fromMarkers: Float64Array;
    toMarkers: Float64Array;
    place: Float64Array;
  }): Float64Array;

  /**
   * The sharp edges of a model that a match keeps, chained into curves between corners.
   * @param angle  degrees; none are sharper than 180
   * @returns source vertices along each; of a closed one the first stands last again
   */
  sharpEdges(args: { model: KernelId; angle: number }): readonly Uint32Array[];
}
