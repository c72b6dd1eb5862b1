import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { ModelKernel } from '../contract/model';
import type { HandlersOf } from '../serve';
import type { Registry } from './registry';

/** Models: opened, measured, released. */
export function modelHandlers(wasm: KernelModule, registry: Registry): HandlersOf<ModelKernel> {
  return {
    openModel({ positions, faceOffsets, faceVertices }) {
      const mesh = new wasm.WorkingMesh(positions, faceOffsets, faceVertices);
      try {
        const described = mesh.describe();
        return { id: registry.add(mesh), ...described };
      } catch (error) {
        mesh.delete();
        throw error;
      }
    },

    measure: ({ model, positions }) => wasm.measure(registry.get(model, wasm.WorkingMesh), positions),

    release: ({ id }) => registry.release(id),
  };
}
