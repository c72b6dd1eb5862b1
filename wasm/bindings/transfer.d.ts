import type { PreparedTransfer, Transferred } from '../../web/kernel/contract/transfer';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface TransferModule {
  readonly TransferSession: new (
    source: WasmWorkingMesh,
    sourceHandles: readonly Uint32Array[],
    target: WasmWorkingMesh,
    targetHandles: readonly Uint32Array[],
  ) => WasmTransferSession;
}

export interface WasmTransferSession extends WasmObject {
  /** One slice of the preparation; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedTransfer, 'id' | 'peakBytes'>;
  transfer(pose: Float64Array, strength: number, keepStretch: boolean): Transferred;
}
