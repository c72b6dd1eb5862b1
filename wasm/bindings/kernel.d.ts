// What the compiled module exports: mirrors wasm/bindings/*.cpp one for one, by hand; a test compares the
// names. Every array passed in is copied, every array handed out belongs to JS. Errors carry `code` and `fault`.

import type {
  Deformed,
  DeformHandleSpec,
  DeformOptions,
  FieldVectors,
  GrownHair,
  HairOptions,
  HairStyle,
  Measured,
  MergeBoundarySpec,
  Merged,
  MergeOptions,
  OpenedHair,
  OpenedModel,
  PaintedRegions,
  PreparedDeform,
  PreparedMerge,
  RegionMaps,
  StyledHair,
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
  readonly HairSession: new (
    model: WasmWorkingMesh,
    scalp: Uint32Array,
    resolution: number,
    up: 'y' | 'z',
  ) => WasmHairSession;
  readonly HairGrowth: new (
    hair: WasmHairSession,
    from: number,
    count: number,
    options: HairOptions,
  ) => WasmHairGrowth;
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

export interface WasmHairSession extends WasmObject {
  /** One slice of the preparation; true while there is more. */
  step(): boolean;
  fraction(): number;
  describe(): Omit<OpenedHair, 'hair' | 'peakBytes'>;
  style(style: HairStyle): StyledHair;
  field(stride: number): FieldVectors;
  constraints(): FieldVectors;
}

export interface WasmHairGrowth extends WasmObject {
  /** Some strands more; true while there are more to grow. */
  step(): boolean;
  fraction(): number;
  /** The strands, once. */
  take(): Omit<GrownHair, 'peakBytes'>;
}

export interface WasmMergeSession extends WasmObject {
  /** One slice of the factorization; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedMerge, 'merge' | 'peakBytes'>;
  merge(keys: readonly Uint32Array[], settle: boolean): Merged;
}

/** What kernel.mjs takes: how to make an instance once the imports are known. */
export interface KernelSettings {
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, compiled: WebAssembly.Module) => void,
  ): WebAssembly.Exports;
}
