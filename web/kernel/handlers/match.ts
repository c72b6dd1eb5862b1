import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { MatchKernel } from '../contract/match';
import type { HandlersOf } from '../serve';
import type { Registry } from './registry';

/** Matches: made in slices, with a look at the skins between them; nothing of one is kept. */
export function matchHandlers(wasm: KernelModule, registry: Registry): HandlersOf<MatchKernel> {
  return {
    async match({ models, options }, job) {
      const opened = models.map(({ model }) => registry.get(model, wasm.WorkingMesh));
      const session = new wasm.MatchSession(opened, models, options);
      try {
        await job.advance(
          () => session.step(),
          () => session.fraction(),
          () => session.look(),
        );
        return { ...session.result(), peakBytes: wasm.peakBytes() };
      } finally {
        session.delete();
      }
    },

    carryPlaces: ({ from, to, triangles, places }) => wasm.carryPlaces(from, to, triangles, places),

    guessPlace: ({ from, to, fromMarkers, toMarkers, place }) =>
      wasm.guessPlace(
        registry.get(from, wasm.WorkingMesh),
        registry.get(to, wasm.WorkingMesh),
        fromMarkers,
        toMarkers,
        place,
      ),

    sharpEdges: ({ model, angle }) => wasm.sharpEdges(registry.get(model, wasm.WorkingMesh), angle),
  };
}
