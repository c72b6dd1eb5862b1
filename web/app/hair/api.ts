import type { HairStep } from '../../recipe/recipe';
import type { PrimitivePatch } from '../../tools/hair/style';

/** Fields of a hair step beside its curves; a group is patched field by field, `undefined` takes a field away. */
export type HairPatch = {
  readonly [G in 'grid' | 'strands' | 'length' | 'detail' | 'material']?: {
    readonly [F in keyof HairStep[G]]?: HairStep[G][F] | undefined;
  };
} & { readonly volume?: number | undefined };

/** Edits of the open hair step. Each call is one step of undo, except previews; primitives by their number. */
export interface HairService {
  select(primitive: number | null): void;
  /** Name as shown: its own, else `Stream 1` … */
  primitiveName(index: number): string;
  rename(index: number, name: string): void;
  hide(index: number, hidden: boolean): void;
  remove(index: number): void;
  duplicate(index: number): void;
  /** Options of a primitive. `live` previews (slider held), then `finish`. */
  setPrimitive(index: number, patch: PrimitivePatch, live?: boolean): void;
  /** Count, length, detail, look … `live` previews, then `finish`. */
  update(patch: HairPatch, live?: boolean): void;
  finish(): void;
  cancel(): void;
  newSeed(): void;
  /** Puts another built-in head under the style; strokes move along with the scalp. */
  setHead(builtin: string): Promise<void>;
  /** How many vertices hair grows from; 0 where a scalp is still to be painted. */
  scalpSize(): number;
  /** Head height of the open step, model units; 1 while none is open. Default lengths are parts of it. */
  headHeight(): number;
  rebuildSupport(): void;
}
