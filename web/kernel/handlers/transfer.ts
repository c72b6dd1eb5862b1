import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { TransferKernel } from '../contract/transfer';
import type { HandlersOf } from '../serve';
import { prepared } from './prepared';
import type { Registry } from './registry';

/** Transfer sessions: prepared in slices, then asked for one pose after another. */
export function transferHandlers(wasm: KernelModule, registry: Registry): HandlersOf<TransferKernel> {
  return {
    prepareTransfer({ source, sourceHandles, target, targetHandles }, job) {
      const session = new wasm.TransferSession(
        registry.get(source, wasm.WorkingMesh),
        sourceHandles,
        registry.get(target, wasm.WorkingMesh),
        targetHandles,
      );
      return prepared(session, job, registry, wasm);
    },

    transfer: ({ transfer, pose, strength, keepStretch }) =>
      registry.get(transfer, wasm.TransferSession).transfer(pose, strength, keepStretch),
  };
}
