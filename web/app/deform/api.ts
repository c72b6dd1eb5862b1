import type { VertexSet } from '../../core/vertex-set';
import type { DeformHandle, DeformStep } from '../../recipe/recipe';
import type { Pose } from '../pose';

/** Edits of the open deform step. Each call is one step of undo, except previews. */
export interface DeformService {
  setRoi(roi: VertexSet): void;
  setMethod(method: DeformStep['method']): void;
  setOptions(options: Partial<DeformStep['options']>): void;
  /** Name as shown: the handle's own, else `Handle 1` … */
  handleName(index: number): string;
  /** How many vertices it holds. */
  handleSize(handle: DeformHandle): number;
  rename(index: number, name: string): void;
  hide(index: number, hidden: boolean): void;
  remove(index: number): void;
  /** Back to rest. */
  reset(index: number): void;
  pose(index: number): Pose | undefined;
  /** Typed-in numbers; a part that is absent stays. `live` previews (slider, arrow held), then `finish`. */
  setPose(index: number, pose: Partial<Pose>, live?: boolean): void;
  finish(): void;
  cancel(): void;
  /** A new deform step on the result of the last one. */
  applyAndContinue(): void;
}
