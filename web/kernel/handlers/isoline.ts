import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { IsolineKernel } from '../contract/isoline';
import type { HandlersOf } from '../serve';
import { prepared } from './prepared';
import type { Registry } from './registry';

/** Global steps that a result may take from the rest pose; drags take a few a frame. */
const TO_THE_END = 60;

/** Isoline sessions: a surface once per mesh, fields and a small factor once per set of handles, then frames. */
export function isolineHandlers(wasm: KernelModule, registry: Registry): HandlersOf<IsolineKernel> {
  return {
    estimateIsolines: ({ model, handles, options }) =>
      wasm.estimateIsolines(registry.get(model, wasm.WorkingMesh), handles, options),

    prepareIsolineModel({ model }, job) {
      const surface = new wasm.IsolineModel(registry.get(model, wasm.WorkingMesh));
      return prepared(surface, job, registry, wasm);
    },

    prepareIsolines({ isolineModel, roi, handles, options }, job) {
      const session = new wasm.IsolineSession(
        registry.get(isolineModel, wasm.IsolineModel),
        roi,
        handles,
        options,
      );
      return prepared(session, job, registry, wasm);
    },

    dragIsolines: ({ isolines, targets, solves = 0 }) =>
      registry.get(isolines, wasm.IsolineSession).drag(targets, solves, false),

    async poseIsolines({ isolines, targets, settle }, job) {
      const session = registry.get(isolines, wasm.IsolineSession);
      const started = performance.now();
      // First what takes long and lets other requests in; from the drag on nothing may come between.
      if (settle)
        await job.advance(
          () => session.settleStep(),
          () => session.fraction(),
        );
      const prepared = performance.now();
      const { seconds, ...frame } = session.drag(targets, TO_THE_END, true);
      const dragged = performance.now();
      const positions = settle ? session.settled() : session.positions();
      const last = (performance.now() - dragged) / 1000;
      return {
        ...frame,
        positions,
        seconds: {
          ...seconds,
          apply: settle ? 0 : last,
          settle: settle ? (prepared - started) / 1000 + last : 0,
        },
      };
    },

    isolineFields: ({ isolines }) => registry.get(isolines, wasm.IsolineSession).fields(),

    isolineField: ({ isolines, handle, what }) => ({
      values: registry.get(isolines, wasm.IsolineSession).field(handle, what),
    }),

    isolineCurves: ({ isolines, handle, count }) =>
      registry.get(isolines, wasm.IsolineSession).curves(handle, count),
  };
}
