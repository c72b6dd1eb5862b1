import type {
  CurveAttributes,
  CurveLink,
  CurveOptions,
  CurvePosture,
  CurveSpec,
  CurveTable,
  PosedCurves,
  PreparedCurves,
} from '../../web/kernel/contract/curve';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface CurveModule {
  readonly CurveSession: new (
    model: WasmWorkingMesh,
    curves: readonly CurveSpec[],
    links: readonly CurveLink[],
    options: CurveOptions,
  ) => WasmCurveSession;
  reachCurve(
    points: Float64Array,
    end: number,
    target: readonly [number, number, number],
    held: Uint32Array,
  ): { readonly points: Float64Array; readonly reached: boolean };
  selfIntersections(
    model: WasmWorkingMesh,
    positions: Float64Array,
  ): { readonly pairs: number; readonly faces: Uint32Array };
}

export interface WasmCurveSession extends WasmObject {
  /** One slice of the preparation; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedCurves, 'id' | 'peakBytes'>;
  pose(postures: readonly CurvePosture[]): Omit<PosedCurves, 'seconds'>;
  attributes(): CurveAttributes;
  table(postures: readonly CurvePosture[]): CurveTable;
  normals(postures: readonly CurvePosture[], normals: Float64Array): Float64Array;
  dragLimit(from: readonly CurvePosture[], to: readonly CurvePosture[]): number;
  parents(postures: readonly CurvePosture[]): Float64Array;
}
