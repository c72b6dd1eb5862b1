import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { HairKernel } from '../contract/hair';
import type { HandlersOf } from '../serve';
import type { Registry } from './registry';

/** Hair: heads prepared in slices, styled at once, grown in slices. */
export function hairHandlers(wasm: KernelModule, registry: Registry): HandlersOf<HairKernel> {
  return {
    async openHair({ model, scalp, resolution, up }, job) {
      const session = new wasm.HairSession(registry.get(model, wasm.WorkingMesh), scalp, resolution, up);
      try {
        await job.advance(
          () => session.step(),
          () => session.fraction(),
        );
        const described = session.describe();
        return { id: registry.add(session), ...described, peakBytes: wasm.peakBytes() };
      } catch (error) {
        session.delete();
        throw error;
      }
    },

    styleHair: ({ hair, style }) => registry.get(hair, wasm.HairSession).style(style),

    async growHair({ hair, from, count, options }, job) {
      const growth = new wasm.HairGrowth(registry.get(hair, wasm.HairSession), from, count, options);
      try {
        await job.advance(
          () => growth.step(),
          () => growth.fraction(),
        );
        return { ...growth.take(), peakBytes: wasm.peakBytes() };
      } finally {
        growth.delete();
      }
    },

    hairField: ({ hair, stride }) => registry.get(hair, wasm.HairSession).field(stride),

    hairConstraints: ({ hair }) => registry.get(hair, wasm.HairSession).constraints(),
  };
}
