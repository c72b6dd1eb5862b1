// What the merge workspace knows beside the document, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { stepOf } from '../../recipe/edit';
import type { MergeStep } from '../../recipe/recipe';
import type { ModelResult } from '../../run/types';
import type { Mark } from '../../tools/merge/host';
import type { Loop } from '../../tools/merge/loops';
import type { Key, MergeSide } from '../../tools/merge/pins';
import type { EvaluatorPort } from '../evaluated';
import type { State } from '../state';

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

/** Two models, and the names they have in the recipe. */
interface Opened {
  readonly names: Readonly<Record<MergeSide, string | null>>;
  readonly models: Sides;
}

const NO_SIDES: Sides = { source: null, target: null };

interface Parts {
  readonly state: Pick<State, 'recipe' | 'selection' | 'choosing' | 'opened'>;
  readonly evaluator: Pick<EvaluatorPort, 'result'>;
}

export class MergeState {
  /** The open step while it is one that merges. */
  readonly step: ReadonlySignal<MergeStep | undefined>;
  /** The model that a part is being chosen for. */
  readonly target = signal<ModelResult | null>(null);
  /** The two models of the open step, or of the one about to be started; `null` while one is not there yet. */
  readonly sides: ReadonlySignal<Sides>;
  /** The step whose marks are not to be merged until the button says so, and the document it is in. */
  readonly #held = signal<{ readonly step: string; readonly opened: number } | null>(null);
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

  constructor(private readonly parts: Parts) {
    const { state, evaluator } = parts;
    this.step = computed(() => stepOf(state.recipe.value, state.selection.value.step, 'merge'));
    const opened = computed((): Opened | null => {
      if (state.choosing.value) {
        const names = { source: null, target: null };
        return { names, models: { source: null, target: this.target.value } };
      }
      const evaluation = evaluator.result.value;
      if (evaluation?.step.type !== 'merge') return null;
      const { source, target } = evaluation.step;
      const [part, goal] = evaluation.inputs as [ModelResult, ModelResult];
      return { names: { source, target }, models: { source: part, target: goal } };
    });
    // The same two models are the same two sides, however often they are merged.
    let last = NO_SIDES;
    this.sides = computed(() => {
      const held = opened.value;
      const open = this.step.value;
      const side = (which: MergeSide): ModelResult | null => {
        if (!held || (!state.choosing.value && open && open[which] !== held.names[which])) return null;
        return held.models[which];
      };
      const next = { source: side('source'), target: side('target') };
      if (next.source !== last.source || next.target !== last.target) last = next;
      return last;
    });
  }

  /** Whether a step waits for its button. Reads signals. */
  isHeld({ id }: Pick<MergeStep, 'id'>): boolean {
    const held = this.#held.value;
    return held?.step === id && held.opened === this.parts.state.opened.value;
  }

  /** Lets a step wait for its button. */
  hold(step: string): void {
    this.#held.value = { step, opened: this.parts.state.opened.peek() };
  }

  letGo(): void {
    this.#held.value = null;
  }
}
