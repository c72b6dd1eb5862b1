import type {
  MergeBoundarySpec,
  Merged,
  MergeOptions,
  PaintedRegions,
  PreparedMerge,
  RegionMaps,
} from '../../web/kernel/contract/merge';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface MergeModule {
  readonly MergeSession: new (
    source: WasmWorkingMesh,
    target: WasmWorkingMesh,
    boundaries: readonly MergeBoundarySpec[],
    roi: Uint32Array,
    handles: readonly { readonly vertices: Uint32Array; readonly matrix: Float64Array }[],
    options: MergeOptions,
  ) => WasmMergeSession;
  mergeAlongOptimalBoundary(
    source: WasmWorkingMesh,
    target: WasmWorkingMesh,
    regions: PaintedRegions,
    options: MergeOptions,
  ): WasmMergeSession;
  mapRegions(source: WasmWorkingMesh, target: WasmWorkingMesh, regions: PaintedRegions): RegionMaps;
  loopsAround(model: WasmWorkingMesh, vertices: Uint32Array): readonly Uint32Array[];
}

export interface WasmMergeSession extends WasmObject {
  /** One slice of the factorization; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedMerge, 'id' | 'peakBytes'>;
  merge(keys: readonly Uint32Array[], settle: boolean): Merged;
}
