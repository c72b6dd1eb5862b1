// What the dress workspace knows beside the document, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { stepOf } from '../../recipe/edit';
import type { DressStep } from '../../recipe/recipe';
import type { ModelResult } from '../../run/types';
import type { State } from '../state';

/** Another garment on the same body. */
export interface Worn {
  readonly id: string;
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
}

/** What came of the last fitting. Times in milliseconds. */
export interface DressFigures {
  /** Vertices of the garment within the body, and centres of its faces: before it was pushed out, and after. */
  readonly before: number;
  readonly after: number;
  readonly prepare: number;
  readonly dress: number;
}

/** How far the garment lies from the body, vertex by vertex. */
export interface Clearance {
  readonly values: Float32Array;
  readonly range: readonly [number, number];
}

export class DressState {
  /** The open step while it is one that dresses. */
  readonly step: ReadonlySignal<DressStep | undefined>;
  /** The body that the garment was made for, of the open step or of the one being started. */
  readonly source = signal<ModelResult | null>(null);
  /** Other garments of the document on the body on screen. */
  readonly others = signal<readonly Worn[]>([]);
  /** The garment as it was is seen through the result. */
  readonly ghost = signal(false);
  /** The garment is coloured by how far it lies from the body. */
  readonly heat = signal(false);
  /** `null` while it is not asked for. */
  readonly clearance = signal<Clearance | null>(null);
  /** Why it could not be fitted. */
  readonly problem = signal<string | null>(null);
  readonly figures = signal<DressFigures | null>(null);

  constructor({ recipe, selection }: Pick<State, 'recipe' | 'selection'>) {
    this.step = computed(() => stepOf(recipe.value, selection.value.step, 'dress'));
  }
}
