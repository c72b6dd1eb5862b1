import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { MergeKernel } from '../contract/merge';
import type { HandlersOf } from '../serve';
import type { Registry } from './registry';

/** Merge sessions: factored in slices, then asked as often as a key moves. */
export function mergeHandlers(wasm: KernelModule, registry: Registry): HandlersOf<MergeKernel> {
  return {
    async prepareMerge({ source, target, boundaries, optimalBoundary, roi, handles, options }, job) {
      const meshes = [
        registry.get(source, wasm.WorkingMesh),
        registry.get(target, wasm.WorkingMesh),
      ] as const;
      const session = optimalBoundary
        ? wasm.mergeAlongOptimalBoundary(...meshes, optimalBoundary, options)
        : new wasm.MergeSession(...meshes, boundaries, roi, handles, options);
      try {
        await job.advance(
          () => session.step(),
          () => session.fraction(),
        );
        const figures = session.figures();
        return { id: registry.add(session), ...figures, peakBytes: wasm.peakBytes() };
      } catch (error) {
        session.delete();
        throw error;
      }
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
