// What the hair workspace knows beside the document, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { stepOf } from '../../recipe/edit';
import type { HairStep } from '../../recipe/recipe';
import type { CurveKind } from '../../tools/hair/style';
import type { Line } from '../../tools/stroke/polyline';
import type { SupportKind, Viewpoint } from '../../tools/stroke/support';
import type { HairOptions } from '../../view/hair/types';
import type { State } from '../state';

/** A stroke under way that is no edit yet. */
export interface ShownStroke {
  readonly line: Line;
  readonly kind: CurveKind;
}

/** What is drawn beside the hair itself. */
export interface HairShow {
  readonly hair: boolean;
  readonly curves: boolean;
  readonly support: boolean;
  readonly field: boolean;
  readonly constraints: boolean;
  readonly volume: boolean;
}

/** Numbers of the last hair grown; times in milliseconds. */
export interface HairFigures {
  readonly constraints: number;
  readonly grid: readonly [number, number, number];
  readonly strands: number;
  readonly update: number;
  readonly field: number;
  readonly grow: number;
  /** From the end of a stroke to its hair on screen. */
  readonly stroke: number | null;
}

export class HairState {
  /** The open step while it is one that grows hair. */
  readonly step: ReadonlySignal<HairStep | undefined>;
  readonly show = signal<HairShow>({
    hair: true,
    curves: true,
    support: true,
    field: false,
    constraints: false,
    volume: false,
  });
  /** The first so many of the strands (0 to 1) are drawn; `null`: as many as the machine allows. */
  readonly share = signal<number | null>(null);
  readonly shading = signal<HairOptions['shading']>('natural');
  /** The factor of the length that the brush paints. */
  readonly lengthBrush = signal(0.5);
  readonly supportKind = signal<SupportKind>('strip');
  /** What supporting surfaces are built for; `null`: not looked at yet. */
  readonly viewpoint = signal<Viewpoint | null>(null);
  readonly stroke = signal<ShownStroke | null>(null);
  /** Whether the pointer is over something the tool can start on. */
  readonly aimed = signal(true);
  readonly figures = signal<HairFigures | null>(null);

  constructor({ recipe, selection }: Pick<State, 'recipe' | 'selection'>) {
    this.step = computed(() => stepOf(recipe.value, selection.value.step, 'hair'));
  }
}
