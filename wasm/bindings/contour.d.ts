import type {
  ContourLines,
  ContourOptions,
  ContourView,
  PreparedContours,
} from '../../web/kernel/contract/contour';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface ContourModule {
  readonly ContourSession: new (model: WasmWorkingMesh, sweeps: number) => WasmContourSession;
}

export interface WasmContourSession extends WasmObject {
  /** One slice of the preparation; true while there is more. */
  step(): boolean;
  fraction(): number;
  figures(): Omit<PreparedContours, 'id' | 'peakBytes'>;
  /** Starts on a view; what was under way is void. @returns its ticket */
  look(view: ContourView, options: ContourOptions): number;
  /** One slice of the view; true while there is more, false for one that is void. */
  lookStep(ticket: number): boolean;
  lookFraction(): number;
  lines(ticket: number): ContourLines;
}
