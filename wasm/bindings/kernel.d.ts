// What the compiled module exports: mirrors wasm/bindings/*.cpp one for one, by hand; a test compares the
// names. Every array passed in is copied, every array handed out belongs to JS. Errors carry `code` and `fault`.

import type {
  Deformed,
  DeformHandleSpec,
  DeformOptions,
  Measured,
  OpenedModel,
  PreparedDeform,
} from '../../web/kernel/contract';

export interface KernelModule {
  readonly WorkingMesh: new (
    positions: Float64Array,
    faceOffsets: Uint32Array,
    faceVertices: Uint32Array,
  ) => WasmWorkingMesh;
  readonly DeformSession: new (
    model: WasmWorkingMesh,
    roi: Uint32Array,
    handles: readonly DeformHandleSpec[],
    options: DeformOptions,
  ) => WasmDeformSession;
  measure(model: WasmWorkingMesh, positions: Float64Array): Measured;
  /** Highest heap address so far, in bytes. */
  peakBytes(): number;
  /** Bytes allocated now. */
  liveBytes(): number;
}

/** A C++ object: freed by `delete` and by nothing else. */
export interface WasmObject {
  delete(): void;
}

export interface WasmWorkingMesh extends WasmObject {
  describe(): Omit<OpenedModel, 'model'>;
}

export interface WasmDeformSession extends WasmObject {
  /** One slice of the factorization; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedDeform, 'deform' | 'peakBytes'>;
  deform(targets: Float64Array, settle: boolean): Deformed;
}

/** What kernel.mjs takes: how to make an instance once the imports are known. */
export interface KernelSettings {
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, compiled: WebAssembly.Module) => void,
  ): WebAssembly.Exports;
}
