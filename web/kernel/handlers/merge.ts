import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { MergeKernel } from '../contract/merge';
import type { HandlersOf } from '../serve';
import { prepared } from './prepared';
import type { Registry } from './registry';

/** Merge sessions: factored in slices, then asked as often as a key moves. */
export function mergeHandlers(wasm: KernelModule, registry: Registry): HandlersOf<MergeKernel> {
  return {
    prepareMerge({ source, target, boundaries, optimalBoundary, roi, handles, options }, job) {
      const meshes = [
        registry.get(source, wasm.WorkingMesh),
        registry.get(target, wasm.WorkingMesh),
      ] as const;
      const session = optimalBoundary
        ? wasm.mergeAlongOptimalBoundary(...meshes, optimalBoundary, options)
        : new wasm.MergeSession(...meshes, boundaries, roi, handles, options);
      return prepared(session, job, registry, wasm);
    },

    merge: ({ merge, keys, settle = true }) => registry.get(merge, wasm.MergeSession).merge(keys, settle),

    mapRegions: ({ source, target, regions }) =>
      wasm.mapRegions(
        registry.get(source, wasm.WorkingMesh),
        registry.get(target, wasm.WorkingMesh),
        regions,
      ),

    loopsAround: ({ model, vertices }) => wasm.loopsAround(registry.get(model, wasm.WorkingMesh), vertices),
  };
}
