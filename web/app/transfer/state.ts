// What the transfer workspace knows beside the document, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { stepOf } from '../../recipe/edit';
import type { DeformStep, TransferStep } from '../../recipe/recipe';
import type { ModelResult } from '../../run/types';
import type { State } from '../state';

/** The model that has the pose. */
export interface SourcePose {
  /** Of the step that has it. */
  readonly id: string;
  /** None where nothing is to be paired. */
  readonly handles: DeformStep['handles'];
  readonly rest: ModelResult;
  /** 3 per vertex. */
  readonly posed: Float64Array;
}

/** What came of the last transfer. Times in milliseconds. */
export interface TransferFigures {
  readonly unknowns: number;
  readonly iterations: number;
  readonly prepare: number;
  readonly transfer: number;
}

/** What the pose did to the model that got it. */
export interface WhatItDid {
  /** 1 = unchanged; of no meaning for an open surface (see `closed`). */
  readonly volumeRatio: number;
  readonly closed: boolean;
  readonly edgeRms: number;
  readonly flippedTriangles: number;
}

export class TransferState {
  /** The open step while it is one that transfers. */
  readonly step: ReadonlySignal<TransferStep | undefined>;
  /** The pose of the open step, or of the one about to be started; `null` until it is there. */
  readonly source = signal<SourcePose | null>(null);
  /** Where the vertices of the model on screen are, of the open step's. */
  readonly positions = signal<Float64Array | null>(null);
  /** Shows both models at rest, where their parts are easier to compare. */
  readonly atRest = signal(false);
  /** Why the pose could not be given. */
  readonly problem = signal<string | null>(null);
  readonly figures = signal<TransferFigures | null>(null);
  readonly whatItDid = signal<WhatItDid | null>(null);

  constructor({ recipe, selection }: Pick<State, 'recipe' | 'selection'>) {
    this.step = computed(() => stepOf(recipe.value, selection.value.step, 'transfer'));
  }
}
