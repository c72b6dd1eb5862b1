import type {
  IsolineFields,
  IsolineFrame,
  IsolineMemory,
  IsolineOptions,
  PreparedIsolineModel,
  PreparedIsolines,
} from '../../web/kernel/contract/isoline';
import type { HandleSpec } from '../../web/kernel/contract/model';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface IsolineModule {
  readonly IsolineModel: new (model: WasmWorkingMesh) => WasmIsolineModel;
  readonly IsolineSession: new (
    model: WasmIsolineModel,
    roi: Uint32Array,
    handles: readonly HandleSpec[],
    options: IsolineOptions,
  ) => WasmIsolineSession;
  estimateIsolines(model: WasmWorkingMesh, handles: number, options: IsolineOptions): IsolineMemory;
}

export interface WasmIsolineModel extends WasmObject {
  /** One slice; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedIsolineModel, 'id' | 'peakBytes'>;
}

export interface WasmIsolineSession extends WasmObject {
  /** One slice of the preparation; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedIsolines, 'id' | 'peakBytes'>;
  drag(targets: Float64Array, solves: number, afresh: boolean): IsolineFrame;
  positions(): Float64Array;
  /** One slice of what settling needs; true while there is more. */
  settleStep(): boolean;
  settled(): Float64Array;
  fields(): IsolineFields;
  field(handle: number, what: 'field' | 'rigidity'): Float32Array;
  curves(handle: number, count: number): { readonly points: Float64Array; readonly offsets: Uint32Array };
}
