import type { GrowingSkins, Matched, MatchedModel, MatchOptions } from '../../web/kernel/contract/match';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface MatchModule {
  readonly MatchSession: new (
    models: readonly WasmWorkingMesh[],
    marked: readonly Omit<MatchedModel, 'model'>[],
    options: MatchOptions,
  ) => WasmMatchSession;
  carryPlaces(
    from: Float64Array,
    to: Float64Array,
    triangles: Uint32Array,
    places: Float64Array,
  ): Float64Array;
  guessPlace(
    from: WasmWorkingMesh,
    to: WasmWorkingMesh,
    fromMarkers: Float64Array,
    toMarkers: Float64Array,
    place: Float64Array,
  ): Float64Array;
  sharpEdges(model: WasmWorkingMesh, angle: number): Uint32Array[];
}

export interface WasmMatchSession extends WasmObject {
  /** One slice; true while there is more. */
  step(): boolean;
  fraction(): number;
  /** The skins as they are; `undefined` before there are any. */
  look(): GrowingSkins | undefined;
  /** Once nothing is left to do. */
  result(): Omit<Matched, 'peakBytes'>;
}
