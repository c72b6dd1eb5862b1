import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { DeformKernel } from '../contract/deform';
import type { HandlersOf } from '../serve';
import { prepared } from './prepared';
import type { Registry } from './registry';

/** Deformation sessions: factored in slices, then asked as often as the pointer moves. */
export function deformHandlers(wasm: KernelModule, registry: Registry): HandlersOf<DeformKernel> {
  return {
    prepareDeform({ model, roi, handles, options }, job) {
      const mesh = registry.get(model, wasm.WorkingMesh);
      const session = new wasm.DeformSession(mesh, roi, handles, options);
      return prepared(session, job, registry, wasm);
    },

    deform: ({ deform, targets, settle = true }) =>
      registry.get(deform, wasm.DeformSession).deform(targets, settle),
  };
}
