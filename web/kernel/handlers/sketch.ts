import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { SketchKernel } from '../contract/sketch';
import type { HandlersOf } from '../serve';
import type { Registry } from './registry';

/** Drawing curves: a surface once per mesh, then strokes, regions and weights on it. */
export function sketchHandlers(wasm: KernelModule, registry: Registry): HandlersOf<SketchKernel> {
  return {
    prepareSketch({ model }) {
      const surface = new wasm.CurveSurface(registry.get(model, wasm.WorkingMesh));
      return { ...surface.figures(), id: registry.add(surface), peakBytes: wasm.peakBytes() };
    },

    sketchCurve: ({ sketch, pixels, origins, directions, options = {} }) =>
      registry.get(sketch, wasm.CurveSurface).sketch(pixels, origins, directions, options),

    curveRegion: ({ sketch, points, options = {} }) =>
      registry.get(sketch, wasm.CurveSurface).region(points, options),

    proposeCurves: ({ sketch }) => registry.get(sketch, wasm.CurveSurface).propose(),

    lineWeights: ({ sketch, line, others, radius }) =>
      registry.get(sketch, wasm.CurveSurface).weights(line, others, radius === undefined ? {} : { radius }),
  };
}
