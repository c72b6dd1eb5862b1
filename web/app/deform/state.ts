// What the deform workspace knows beside the document, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { stepOf } from '../../recipe/edit';
import type { DeformStep } from '../../recipe/recipe';
import type { GizmoMode } from '../../view/types';
import type { Moving } from '../motion-sync';
import type { State } from '../state';

/** Lines of the selected handle's harmonic field, the field itself, or how rigid the surface stays (Isolines fig. 1-4). */
export type IsolineView = 'nothing' | 'lines' | 'field' | 'rigidity';

/** What the open step did to its model. */
export interface WhatItDid {
  /** 1 = unchanged; of no meaning for an open surface (see `closed`). */
  readonly volumeRatio: number;
  readonly closed: boolean;
  /** l/l₀ − 1 of the edge whose length changed most: above 0 stretched, below squeezed. */
  readonly worstStretch: number;
  readonly edgeRms: number;
  readonly flippedTriangles: number;
  readonly handlesMet: number;
  readonly handles: number;
}

export class DeformState implements Moving {
  /** The open step while it is one that deforms. */
  readonly step: ReadonlySignal<DeformStep | undefined>;
  readBack: Moving['readBack'] = () => null;
  readonly movable = signal(false);
  readonly gizmo = signal<GizmoMode>('translate');
  readonly heat = signal(false);
  /** What of the isoline method is drawn on the surface. */
  readonly isolines = signal<IsolineView>('nothing');
  /** Range of the heat map's legend: mean edge stretch, l/l₀ − 1. */
  readonly heatRange = signal<readonly [number, number]>([-0.5, 0.5]);
  /** A field of the isoline method, while it is shown. */
  readonly field = signal<{
    readonly values: Float32Array;
    readonly range: readonly [number, number];
  } | null>(null);
  readonly whatItDid = signal<WhatItDid | null>(null);
  /** Per source vertex: mean of l/l₀ − 1 over its edges, for the heat map. */
  readonly stretch = signal<Float32Array | null>(null);

  constructor({ recipe, selection }: Pick<State, 'recipe' | 'selection'>) {
    this.step = computed(() => stepOf(recipe.value, selection.value.step, 'deform'));
  }
}
