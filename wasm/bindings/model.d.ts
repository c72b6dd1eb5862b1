import type { Measured, OpenedModel } from '../../web/kernel/contract/model';

/** A C++ object: freed by `delete` and by nothing else. */
export interface WasmObject {
  delete(): void;
}

export interface ModelModule {
  readonly WorkingMesh: new (
    positions: Float64Array,
    faceOffsets: Uint32Array,
    faceVertices: Uint32Array,
  ) => WasmWorkingMesh;
  measure(model: WasmWorkingMesh, positions: Float64Array): Measured;
  /** Highest heap address so far, in bytes. */
  peakBytes(): number;
  /** Bytes allocated now. */
  liveBytes(): number;
}

export interface WasmWorkingMesh extends WasmObject {
  describe(): Omit<OpenedModel, 'id'>;
}
