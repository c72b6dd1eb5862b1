import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { CurveKernel } from '../contract/curve';
import type { HandlersOf } from '../serve';
import { prepared } from './prepared';
import type { Registry } from './registry';

/** Curve sessions: regions and places once, then one pose after another. */
export function curveHandlers(wasm: KernelModule, registry: Registry): HandlersOf<CurveKernel> {
  return {
    prepareCurves({ model, curves, links, options }, job) {
      const session = new wasm.CurveSession(registry.get(model, wasm.WorkingMesh), curves, links, options);
      return prepared(session, job, registry, wasm);
    },

    poseCurves({ curves, postures }) {
      const started = performance.now();
      const posed = registry.get(curves, wasm.CurveSession).pose(postures);
      return { ...posed, seconds: { pose: (performance.now() - started) / 1000 } };
    },

    curveAttributes: ({ curves }) => registry.get(curves, wasm.CurveSession).attributes(),

    curveTable: ({ curves, postures }) => registry.get(curves, wasm.CurveSession).table(postures),

    curveNormals: ({ curves, postures, normals }) => ({
      normals: registry.get(curves, wasm.CurveSession).normals(postures, normals),
    }),

    curveDragLimit: ({ curves, from, to }) => ({
      share: registry.get(curves, wasm.CurveSession).dragLimit(from, to),
    }),

    curveParents: ({ curves, postures }) => ({
      matrices: registry.get(curves, wasm.CurveSession).parents(postures),
    }),

    reachCurve: ({ points, end, target, held }) => wasm.reachCurve(points, end, target, held),

    selfIntersections: ({ model, positions }) =>
      wasm.selfIntersections(registry.get(model, wasm.WorkingMesh), positions),
  };
}
