// What the blend workspace knows beside the document, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { stepOf } from '../../recipe/edit';
import type { BlendStep } from '../../recipe/recipe';
import type { ModelResult } from '../../run/types';
import type { Three } from '../../tools/blend/weights';
import type { Moving } from '../motion-sync';
import type { State } from '../state';

/** What is blended: shapes of one connectivity, by the names of their models. */
export interface Skins {
  readonly names: readonly string[];
  /** Of each: 3 per vertex. */
  readonly positions: readonly Float64Array[];
  /** The first of them, as it is on screen. */
  readonly skin: ModelResult;
}

export interface LengthBegun {
  readonly from: number;
  readonly to: number | null;
  readonly straight: boolean;
}

/** What came of the last blend. */
export interface BlendFigures {
  /** By model: as given, or as the measures ask. */
  readonly weights: Readonly<Record<string, number>>;
  /** Of each measure: what it is. */
  readonly reached: readonly number[];
  /** Milliseconds. */
  readonly prepare: number;
  readonly blend: number;
}

export class BlendState implements Moving {
  /** The open step while it is one that blends. */
  readonly step: ReadonlySignal<BlendStep | undefined>;
  /** `null` until they are there. */
  readonly skins = signal<Skins | null>(null);
  /** By model: each measure of its skin; `null` until they are known. */
  readonly spread = signal<Readonly<Record<string, readonly number[]>> | null>(null);
  /** Addresses of pictures of the skins, by model. */
  readonly pictures = signal<ReadonlyMap<string, string>>(new Map());
  /** The models at the corners of the triangle; the first three until they are chosen. */
  readonly corners = signal<Three | null>(null);
  /** A weight that is moved leaves the others alone: they need not sum to 1. */
  readonly free = signal(false);
  /** The length between two vertices that is under way; `to` is what the pointer is over. */
  readonly length = signal<LengthBegun | null>(null);
  /** Whose shape the next part that is painted takes; `null`: that of the model that counts for least. */
  readonly nextFrom = signal<string | null>(null);
  /** Why it could not be blended. */
  readonly problem = signal<string | null>(null);
  readonly figures = signal<BlendFigures | null>(null);
  readonly movable = signal(false);
  readBack: Moving['readBack'] = () => null;

  constructor({ recipe, selection }: Pick<State, 'recipe' | 'selection'>) {
    this.step = computed(() => stepOf(recipe.value, selection.value.step, 'blend'));
  }
}
