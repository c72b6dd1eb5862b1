import type {
  Blended,
  Dressed,
  MeasureSpec,
  PartSpec,
  PreparedBlend,
  PreparedDress,
  PreparedThrough,
  SurfacePlaces,
  TransferredThrough,
} from '../../web/kernel/contract/wear';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface WearModule {
  readonly BlendSession: new (
    triangles: Uint32Array,
    positions: readonly Float64Array[],
    parts: readonly PartSpec[],
  ) => WasmBlendSession;
  readonly DressSession: new (
    garment: WasmWorkingMesh,
    triangles: Uint32Array,
    from: Float64Array,
    to: Float64Array,
    model: WasmWorkingMesh | null,
  ) => WasmDressSession;
  readonly SkinPose: new (
    source: WasmWorkingMesh,
    target: WasmWorkingMesh,
    triangles: Uint32Array,
    from: Float64Array,
    to: Float64Array,
  ) => WasmSkinPose;
  placesOn(model: WasmWorkingMesh, points: Float64Array): SurfacePlaces;
}

export interface WasmBlendSession extends WasmObject {
  /** One slice of the preparation; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedBlend, 'id' | 'peakBytes'>;
  blend(weights: Float64Array, measures: readonly MeasureSpec[]): Blended;
}

export interface WasmDressSession extends WasmObject {
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedDress, 'id' | 'peakBytes'>;
  dress(offset: number): Dressed;
}

export interface WasmSkinPose extends WasmObject {
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedThrough, 'id' | 'peakBytes'>;
  give(pose: Float64Array, strength: number, keepStretch: boolean): TransferredThrough;
}
