// What is known of the drawing of the view and of the line in hand, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { ContourLines } from '../../../kernel/contract/contour';
import type { CurvesStep } from '../../../recipe/recipe';
import { curveById } from '../../../recipe/steps/curves-edits';
import type { PickedLine } from '../../../tools/curves/contours/picked';
import type { PenPart } from '../../../view/overlays/types';
import type { State } from '../../state';

export interface InHand {
  readonly picked: PickedLine;
  /** With the line in it, whether or not the document has it yet. */
  readonly step: CurvesStep;
  /** Id of the line's curve. */
  readonly curve: string;
  /** The open step as it was when the line was picked. */
  readonly base: CurvesStep;
}

/** Why there are no lines. */
export type NoLines = 'no-faces' | 'stopped' | 'failed';

export class ContoursState {
  /** The model is drawn with a pen. */
  readonly on: ReadonlySignal<boolean>;
  /** From few lines to many, in [0, 1]. */
  readonly detail = signal(0.5);
  /** Sweeps of smoothing the curvature. */
  readonly smoothing = signal(15);
  readonly suggestive = signal(true);
  /** Lines beside the one that is pulled stay. */
  readonly beside = signal(true);
  readonly lines = signal<ContourLines | null>(null);
  readonly problem = signal<NoLines | null>(null);
  /** Under the pointer: a line by its number, or a part of the line in hand. */
  readonly lit = signal<{ readonly line: number | null; readonly part: PenPart | null }>({
    line: null,
    part: null,
  });
  readonly hand = signal<InHand | null>(null);
  /** The line in hand is being trimmed, or its reach changed. */
  readonly adjusting = signal(false);
  /** How much of a pull each vertex takes. */
  readonly weights = signal<Float32Array | null>(null);
  /** The document has the line in hand. */
  readonly isKept: ReadonlySignal<boolean>;

  constructor(
    { tool, workspace }: Pick<State, 'tool' | 'workspace'>,
    step: ReadonlySignal<CurvesStep | undefined>,
  ) {
    this.on = computed(() => tool.value === 'contours' && workspace.value === 'curves');
    this.isKept = computed(() => {
      const hand = this.hand.value;
      const open = step.value;
      return !!hand && open?.id === hand.step.id && curveById(open, hand.curve) !== undefined;
    });
  }
}
