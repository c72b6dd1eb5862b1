import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { ModelId } from '../contract';
import type { Handlers } from '../serve';
import type { Registry } from './registry';

/** Models: opened, measured, released. */
export function modelHandlers(
  wasm: KernelModule,
  registry: Registry,
): Pick<Handlers, 'openModel' | 'measure' | 'release'> {
  return {
    openModel({ positions, faceOffsets, faceVertices }) {
      const mesh = new wasm.WorkingMesh(positions, faceOffsets, faceVertices);
      try {
        const described = mesh.describe();
        return { model: registry.add<ModelId>(mesh), ...described };
      } catch (error) {
        mesh.delete();
        throw error;
      }
    },

    measure: ({ model, positions }) => wasm.measure(registry.get(model, wasm.WorkingMesh), positions),

    release: ({ id }) => registry.release(id),
  };
}
