// What the match workspace knows beside the document, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { GrowingSkins } from '../../kernel/contract/match';
import { stepOf } from '../../recipe/edit';
import type { MatchStep } from '../../recipe/recipe';
import { MAX_MARKER_CURVES, MAX_MARKERS } from '../../recipe/steps/match';
import type { ModelResult } from '../../run/types';
import type { Spot } from '../../tools/match/places';
import type { Line } from '../../tools/stroke/polyline';
import type { Skin } from '../../view/match/types';
import type { EvaluatorPort } from '../evaluated';
import type { State } from '../state';
import type { Matching } from './result';

/** What a pane shows of its model. */
export const LOOKS = ['model', 'skin', 'both'] as const;
export type PaneLook = (typeof LOOKS)[number];

/** Where the selected marker may belong on a model that it is not set on yet. */
export interface Ghost {
  readonly marker: number;
  readonly model: number;
  readonly spot: Spot;
}

/** A stroke under way: what of a model will be ignored, or a line on it. */
export interface Stroke {
  readonly model: number;
  readonly mask?: Uint32Array;
  readonly line?: Line;
}

/** Items of the step by one number, as selections have them: markers, then curves, then picked edges of each model. */
export const curveItem = (curve: number): number => MAX_MARKERS + curve;
const FIRST_EDGE = MAX_MARKERS + MAX_MARKER_CURVES;
export const sharpItem = ({ model, row }: SharpRow): number => FIRST_EDGE + model * MAX_MARKER_CURVES + row;

/** A picked sharp edge: of which model, and its number there. */
export interface SharpRow {
  readonly model: number;
  readonly row: number;
}

export const curveOf = (item: number): number | null =>
  item >= MAX_MARKERS && item < FIRST_EDGE ? item - MAX_MARKERS : null;

export const sharpOf = (item: number): SharpRow | null =>
  item < FIRST_EDGE
    ? null
    : {
        model: Math.floor((item - FIRST_EDGE) / MAX_MARKER_CURVES),
        row: (item - FIRST_EDGE) % MAX_MARKER_CURVES,
      };

interface Parts {
  readonly state: Pick<State, 'recipe' | 'selection' | 'choosing' | 'opened'>;
  readonly evaluator: Pick<EvaluatorPort, 'result'>;
}

export class MatchState {
  /** The open step while it is one that matches. */
  readonly step: ReadonlySignal<MatchStep | undefined>;
  /** Number of the selected marker, of the selected curve. */
  readonly marker: ReadonlySignal<number | null>;
  readonly curve: ReadonlySignal<number | null>;
  /** The selected one of the edges that were picked. */
  readonly sharp: ReadonlySignal<SharpRow | null>;
  /** The first model of a step that is about to be started. */
  readonly first = signal<ModelResult | null>(null);
  /** The models of the open step, in its order; while one of them is not there yet: none. */
  readonly models: ReadonlySignal<readonly ModelResult[]>;
  /** The last match of the open step, of the same models. */
  readonly result = signal<Matching | null>(null);
  /** Whether the step says something else by now than what was matched. */
  readonly outdated: ReadonlySignal<boolean>;
  /** The skins of the match under way. */
  readonly growing = signal<readonly (Skin | null)[] | null>(null);
  readonly running = signal(false);
  /** Why the models could not be matched. */
  readonly problem = signal<string | null>(null);
  /** What a pane was asked to show, by the name of its model. */
  readonly looks = signal<Readonly<Record<string, PaneLook>>>({});
  /** Colours skins by how far they lie from their models. */
  readonly heat = signal(false);
  readonly edges = signal(true);
  readonly ghosts = signal<readonly Ghost[]>([]);
  /** Of each model: the sharp edges that the angle keeps, as rows of vertices. */
  readonly kept = signal<readonly (readonly Uint32Array[])[]>([]);
  readonly stroke = signal<Stroke | null>(null);
  /** Number of the skin that other workspaces go on with. */
  readonly chosen = signal(0);
  /** The skins' vertex that is looked at because it lies poorly. */
  readonly poor = signal<number | null>(null);
  /** The step that waits for its button, and the document it is in. */
  readonly #held = signal<{ readonly step: string; readonly opened: number } | null>(null);
  /** What the button was pressed for. */
  readonly #asked = signal<ReadonlySet<MatchStep>>(new Set());

  constructor(private readonly parts: Parts) {
    const { state } = parts;
    this.step = computed(() => stepOf(state.recipe.value, state.selection.value.step, 'match'));
    const item = computed(() => (this.step.value ? state.selection.value.item : null));
    this.marker = computed(() => (item.value !== null && item.value < MAX_MARKERS ? item.value : null));
    this.curve = computed(() => (item.value === null ? null : curveOf(item.value)));
    this.sharp = computed(() => (item.value === null ? null : sharpOf(item.value)));
    // The same models are the same list, however often they are matched.
    let last: readonly ModelResult[] = [];
    this.models = computed(() => {
      const next = this.#modelsNow();
      if (next.length !== last.length || next.some((model, at) => model !== last[at])) last = next;
      return last;
    });
    this.outdated = computed(() => {
      const result = this.result.value;
      return result !== null && this.step.value !== result.of;
    });
  }

  /** Whether a step waits for its button. Reads signals. */
  isHeld({ id }: Pick<MatchStep, 'id'>): boolean {
    const held = this.#held.value;
    return held?.step === id && held.opened === this.parts.state.opened.value;
  }

  /** Whether the button was pressed for a step as it is. Reads signals. */
  isAsked(step: MatchStep): boolean {
    return this.#asked.value.has(step);
  }

  /** Lets a step wait for its button. */
  hold(step: string): void {
    const opened = this.parts.state.opened.peek();
    const held = this.#held.peek();
    if (held?.step !== step || held.opened !== opened) this.#held.value = { step, opened };
  }

  ask(step: MatchStep): void {
    this.#asked.value = new Set([...this.#asked.peek(), step]);
  }

  withdraw(step: MatchStep): void {
    this.#asked.value = new Set([...this.#asked.peek()].filter((each) => each !== step));
  }

  /** What a pane shows. Reads signals. */
  lookOf(model: number): PaneLook {
    const name = this.step.value?.models[model];
    const wanted = name === undefined ? undefined : this.looks.value[name];
    if (!this.skinOf(model)) return 'model';
    return this.growing.value ? 'both' : (wanted ?? 'both');
  }

  /** That of the match under way, else of the last one. Reads signals. */
  skinOf(model: number): Skin | null {
    const growing = this.growing.value;
    if (growing) return growing[model] ?? null;
    return this.result.value?.skins[model] ?? null;
  }

  #modelsNow(): readonly ModelResult[] {
    const step = this.step.value;
    if (!step) {
      const first = this.parts.state.choosing.value && this.first.value;
      return first ? [first] : [];
    }
    const evaluation = this.parts.evaluator.result.value;
    if (evaluation?.step.type !== 'match') return [];
    const { models } = evaluation.step;
    const found = step.models.map((name) => evaluation.inputs[models.indexOf(name)]);
    return found.every((each) => each !== undefined) ? found : [];
  }
}

/** Matched pair by pair, not every model has a skin yet. */
export const growingSkins = ({ triangles, positions }: GrowingSkins): (Skin | null)[] =>
  positions.map((each) => (each.length > 0 ? { triangles, positions: each } : null));
