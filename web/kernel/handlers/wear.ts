import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { WearKernel } from '../contract/wear';
import type { HandlersOf } from '../serve';
import { prepared } from './prepared';
import type { Registry } from './registry';

/** Blends, garments and poses: prepared in slices, then asked again and again. */
export function wearHandlers(wasm: KernelModule, registry: Registry): HandlersOf<WearKernel> {
  return {
    prepareBlend: ({ triangles, positions, parts }, job) =>
      prepared(new wasm.BlendSession(triangles, positions, parts), job, registry, wasm),

    blend: ({ blend, weights, measures }) => registry.get(blend, wasm.BlendSession).blend(weights, measures),

    prepareDress({ garment, triangles, from, to, model }, job) {
      const session = new wasm.DressSession(
        registry.get(garment, wasm.WorkingMesh),
        triangles,
        from,
        to,
        model === undefined ? null : registry.get(model, wasm.WorkingMesh),
      );
      return prepared(session, job, registry, wasm);
    },

    placesOn: ({ model, points }) => wasm.placesOn(registry.get(model, wasm.WorkingMesh), points),

    dress: ({ dress, offset }) => registry.get(dress, wasm.DressSession).dress(offset),

    prepareTransferThrough({ source, target, triangles, from, to }, job) {
      const [a, b] = [registry.get(source, wasm.WorkingMesh), registry.get(target, wasm.WorkingMesh)];
      return prepared(new wasm.SkinPose(a, b, triangles, from, to), job, registry, wasm);
    },

    transferThrough: ({ transfer, pose, strength, keepStretch }) =>
      registry.get(transfer, wasm.SkinPose).give(pose, strength, keepStretch),
  };
}
