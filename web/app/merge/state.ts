// What the merge workspace knows beside the document, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { MergeStep, Recipe } from '../../recipe/recipe';
import type { ModelResult } from '../../run/types';
import type { Mark } from '../../tools/merge/host';
import type { Loop } from '../../tools/merge/loops';
import type { Key, MergeSide } from '../../tools/merge/pins';

/** A part is being chosen, for as long as the recipe stays this one. */
export interface Choosing {
  readonly recipe: Recipe;
  /** Name of what the part is to be added to. */
  readonly target: string;
  /** Id of the merge step that shall have another part; `null`: a new step begins. */
  readonly swaps: string | null;
}

/** A loop of one of the two models. */
export interface SideLoop {
  readonly side: MergeSide;
  readonly loop: Loop;
}

/** What came of the last merge. */
export interface MergeFigures {
  readonly seamVertices: number;
  readonly closed: boolean;
  readonly eulerCharacteristic: number;
  /** Degrees: below it lie 90 % of the seam's edges, and of the two models' own. */
  readonly seamDihedral: number;
  readonly ownDihedral: number;
  /** Of the optimal boundary, round by round; empty where loops were given. */
  readonly energy: readonly number[];
  /** Keys it worked with, boundary by boundary. */
  readonly keys: readonly (readonly Key[])[];
}

export type Sides = Readonly<Record<MergeSide, ModelResult | null>>;

/** A model that is open, and the name it has in the recipe. */
interface Named {
  readonly name: string;
  readonly result: ModelResult;
}

export const NO_SIDES: Readonly<Record<MergeSide, Named | null>> = { source: null, target: null };

export class MergeState {
  /** What was opened last for the two panes. */
  readonly opened = signal(NO_SIDES);
  /** The two models of the open step, or of the one about to be started; `null` while one is not there yet. */
  readonly sides: ReadonlySignal<Sides>;
  readonly choosing = signal<Choosing | null>(null);
  /** Id of the step whose marks are not to be merged until the button says so. */
  readonly held = signal<string | null>(null);
  /** Shows the merge along the edge of the region, without the search for a better line. */
  readonly before = signal(false);
  /** Whether the brush marks both sides of what is thin. */
  readonly through = signal(true);
  /** Why the open step could not be merged. */
  readonly problem = signal<string | null>(null);
  /** The stroke under way. */
  readonly paint = signal<{ readonly mark: Mark; readonly vertices: Uint32Array } | null>(null);
  readonly hovered = signal<SideLoop | null>(null);
  /** An opening that waits for its partner on the other model. */
  readonly picked = signal<SideLoop | null>(null);
  readonly figures = signal<MergeFigures | null>(null);

  /** @param step  the open one while it is one that merges */
  constructor(step: ReadonlySignal<MergeStep | undefined>) {
    const side = (which: MergeSide): ModelResult | null => {
      const held = this.opened.value[which];
      const open = step.value;
      const isMeant = !open || this.choosing.value !== null || open[which] === held?.name;
      return held && isMeant ? held.result : null;
    };
    this.sides = computed(() => ({ source: side('source'), target: side('target') }));
  }
}
