import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { ContourKernel } from '../contract/contour';
import type { HandlersOf } from '../serve';
import { prepared } from './prepared';
import type { Registry } from './registry';

const SWEEPS = 10;

/** Contour sessions: curvature in slices, then views, each in slices too, as models may be large. */
export function contourHandlers(wasm: KernelModule, registry: Registry): HandlersOf<ContourKernel> {
  return {
    prepareContours({ model, sweeps = SWEEPS }, job) {
      const session = new wasm.ContourSession(registry.get(model, wasm.WorkingMesh), sweeps);
      return prepared(session, job, registry, wasm);
    },

    async contourLines({ contours, view, options = {} }, job) {
      const session = registry.get(contours, wasm.ContourSession);
      const ticket = session.look(view, options);
      await job.advance(
        () => session.lookStep(ticket),
        () => session.lookFraction(),
      );
      return session.lines(ticket);
    },
  };
}
