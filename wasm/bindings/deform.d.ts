import type { Deformed, DeformOptions, PreparedDeform } from '../../web/kernel/contract/deform';
import type { HandleSpec } from '../../web/kernel/contract/model';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface DeformModule {
  readonly DeformSession: new (
    model: WasmWorkingMesh,
    roi: Uint32Array,
    handles: readonly HandleSpec[],
    options: DeformOptions,
  ) => WasmDeformSession;
}

export interface WasmDeformSession extends WasmObject {
  /** One slice of the factorization; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedDeform, 'id' | 'peakBytes'>;
  deform(targets: Float64Array, settle: boolean): Deformed;
}
