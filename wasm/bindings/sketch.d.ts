import type {
  CurveRegion,
  LineWeights,
  PreparedSketch,
  ProposedCurves,
  RegionOptions,
  SketchedCurve,
  SketchOptions,
} from '../../web/kernel/contract/sketch';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface SketchModule {
  readonly CurveSurface: new (model: WasmWorkingMesh) => WasmCurveSurface;
}

export interface WasmCurveSurface extends WasmObject {
  figures(): Omit<PreparedSketch, 'id' | 'peakBytes'>;
  sketch(
    pixels: Float64Array,
    origins: Float64Array,
    directions: Float64Array,
    options: SketchOptions,
  ): SketchedCurve;
  region(points: Float64Array, options: RegionOptions): CurveRegion;
  propose(): ProposedCurves;
  weights(
    line: Float64Array,
    others: readonly Float64Array[],
    options: { readonly radius?: number },
  ): LineWeights;
}
