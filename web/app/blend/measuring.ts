// Measures of the shape: where they are taken, and what is wanted of them.

import { type BlendMeasure, type BlendStep, MAX_MEASURED } from '../../recipe/steps/blend';
import { addedMeasures, wanting, withMeasure, withoutMeasure } from '../../tools/blend/edits';
import type { Length } from '../../tools/blend/host';
import { Levels, PRESETS } from '../../tools/blend/levels';
import type { Direction } from '../../tools/blend/section';
import { t } from '../i18n';
import { SurfaceAids } from '../surface-aids';
import type { WingParts } from '../wing-parts';
import type { BlendEdits } from './edits';
import type { BlendState, Skins } from './state';

/** How far a tape is moved up or down, as a share of the height. */
const STEP = 0.01;
/** How much farther than the models' own a slider goes, as a share of their spread. */
const BEYOND = 0.5;

export interface MeasureRow {
  readonly index: number;
  readonly kind: BlendMeasure['kind'];
  readonly name: string;
  /** What the shape has; `null` until that is known. */
  readonly reached: number | null;
  /** What is wanted; `null`: it is only measured. */
  readonly value: number | null;
  /** Ends of the slider; `null` until they are known. */
  readonly range: readonly [number, number] | null;
  /** Whether it lies on a level that can be moved. */
  readonly moves: boolean;
  /** Whether a length goes straight through; `null`: it is none. */
  readonly straight: boolean | null;
}

export class Measuring {
  readonly #aids = new SurfaceAids();
  #levels: { readonly of: Skins; readonly levels: Levels } | null = null;

  constructor(
    private readonly edits: BlendEdits,
    private readonly own: BlendState,
    private readonly messages: WingParts['messages'],
  ) {}

  /** Reads signals. */
  rows(): readonly MeasureRow[] {
    const step = this.own.step.value;
    const reached = this.own.figures.value?.reached;
    return (step?.measures ?? []).map((measure, index) => ({
      index,
      kind: measure.kind,
      name: this.nameOf(measure, index),
      reached: reached?.[index] ?? null,
      value: measure.value ?? null,
      range: this.#range(index, measure.value),
      moves: measure.kind === 'girth' && measure.vertex !== undefined,
      straight: measure.kind === 'length' ? measure.path.length === 2 : null,
    }));
  }

  nameOf(measure: BlendMeasure, index: number): string {
    return measure.name ?? t(`blend.measure.${measure.kind}`, { number: index + 1 });
  }

  /** Whether any measure is wanted: then weights are found. Reads signals. */
  isWanted(): boolean {
    return this.own.step.value?.measures.some(({ value }) => value !== undefined) ?? false;
  }

  /** Whether the skin stands like a body that has a chest, a waist and hips. Reads signals. */
  isBody(): boolean {
    const levels = this.#of(this.own.skins.value);
    return levels?.isUpright ?? false;
  }

  /** Height, chest, waist and hip, those that are not there yet. */
  addPresets(): void {
    const { step } = this.edits;
    const levels = this.#of(this.own.skins.peek());
    if (!step || !levels) return;
    const up: [number, number, number] = [...levels.up];
    const held = new Set(step.measures.map(({ name }) => name));
    const height: BlendMeasure = { kind: 'height', name: t('blend.preset.height'), up };
    const girths = PRESETS.flatMap((preset): BlendMeasure[] => {
      const name = t(`blend.preset.${preset}`);
      const vertex = held.has(name) ? null : levels.preset(preset);
      return vertex === null ? [] : [{ kind: 'girth', name, vertex, normal: up, hull: true }];
    });
    const added = [...(held.has(height.name) ? [] : [height]), ...girths];
    if (added.length > 0) this.edits.commit(t('history.blend.measures'), addedMeasures(step, added));
  }

  addHeight(): void {
    const { step } = this.edits;
    const levels = this.#of(this.own.skins.peek());
    if (!step || !levels) return;
    const height: BlendMeasure = { kind: 'height', up: [...levels.up] };
    this.edits.commit(t('history.blend.measures'), addedMeasures(step, [height]));
  }

  /** Where the skin is pointed at. */
  addGirth(vertex: number): void {
    const { step } = this.edits;
    const levels = this.#of(this.own.skins.peek());
    if (!step || !levels) return;
    const girth: BlendMeasure = { kind: 'girth', vertex, normal: [...levels.up], hull: true };
    this.edits.commit(t('history.blend.measures'), addedMeasures(step, [girth]));
  }

  /** Between two vertices: along edges, or straight through. */
  addLength(from: number, to: number, straight: boolean): void {
    const { step } = this.edits;
    this.own.length.value = null;
    const path = this.pathOf({ from, to, straight });
    if (!step || !path) {
      if (step) this.messages.toast('info', t('blend.length-nowhere'));
      return;
    }
    this.edits.commit(t('history.blend.measures'), addedMeasures(step, [{ kind: 'length', path }]));
  }

  /** Between its ends straight through, or along edges. */
  straighten(index: number, straight: boolean): void {
    const { step } = this.edits;
    const measure = step?.measures[index];
    if (!step || measure?.kind !== 'length') return;
    const path = this.pathOf({ from: measure.path[0]!, to: measure.path.at(-1)!, straight });
    if (!path) return;
    const label = t('history.blend.move-measure', { name: this.nameOf(measure, index) });
    // Another length has other values.
    this.edits.commit(label, withMeasure(step, index, wanting({ ...measure, path }, undefined)));
  }

  /** Vertices along a length; `null`: no edges lead from one end to the other. */
  pathOf({ from, to, straight }: Length): number[] | null {
    if (straight) return [from, to];
    const skins = this.own.skins.peek();
    const path = skins && this.#aids.edgesOf(skins.skin).path(from, to, false);
    return path && path.length > 1 && path.length <= MAX_MEASURED ? path : null;
  }

  /** @param by  1: up, −1: down */
  move(index: number, by: 1 | -1): void {
    const { step } = this.edits;
    const measure = step?.measures[index];
    const levels = this.#of(this.own.skins.peek());
    if (!step || !levels || measure?.kind !== 'girth' || measure.vertex === undefined) return;
    const vertex = levels.moved(measure.vertex, by * STEP);
    const label = t('history.blend.move-measure', { name: this.nameOf(measure, index) });
    this.edits.commit(label, withMeasure(step, index, { ...measure, vertex }));
  }

  /** @param value  left out: it is only measured */
  want(index: number, value: number | undefined, live = false): void {
    const step = live ? this.own.step.peek() : this.edits.step;
    const measure = step?.measures[index];
    if (!step || !measure) return;
    const wanted = value === undefined ? undefined : Number(value.toPrecision(5));
    const label = t('history.blend.want', { name: this.nameOf(measure, index) });
    this.edits.put(label, withMeasure(step, index, wanting(measure, wanted)), live);
  }

  remove(index: number): void {
    const { step } = this.edits;
    const measure = step?.measures[index];
    if (!step || !measure) return;
    const label = t('history.blend.remove-measure', { name: this.nameOf(measure, index) });
    this.edits.commit(label, withoutMeasure(step, index));
  }

  /** The step whose measures are only measured. */
  released(step: BlendStep): BlendStep {
    return { ...step, measures: step.measures.map((measure) => wanting(measure, undefined)) };
  }

  #range(index: number, value: number | undefined): readonly [number, number] | null {
    const spread = this.own.spread.value;
    const values = Object.values(spread ?? {}).flatMap((each) => each[index] ?? []);
    if (values.length === 0) return null;
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const more = BEYOND * (high - low) || 0.1 * high;
    const ends = [Math.max(0, low - more), high + more] as const;
    return value === undefined ? ends : [Math.min(ends[0], value), Math.max(ends[1], value)];
  }

  #of(skins: Skins | null): Levels | null {
    if (!skins) return null;
    if (this.#levels?.of !== skins) {
      const { model, opened } = skins.skin;
      const up: Direction = model.upAxis === 'z' ? [0, 0, 1] : [0, 1, 0];
      this.#levels = { of: skins, levels: new Levels(model.positions, opened.triangles, up) };
    }
    return this.#levels!.levels;
  }
}
