// Edits of the open deform step that panels and commands ask for; each is one step of undo.

import type { VertexSet } from '../../core/vertex-set';
import { toIndices } from '../../core/vertex-set';
import * as edit from '../../recipe/edit';
import type { DeformHandle, DeformStep, Recipe } from '../../recipe/recipe';
import { newDeformStep } from '../../recipe/steps/deform';
import * as edits from '../../recipe/steps/deform-edits';
import { atRest, toRest, withHandle } from '../../tools/deform/edits';
import {
  centroid,
  compose,
  decompose,
  multiply,
  type Parts,
  pointAt,
  subtract,
  translation,
} from '../../tools/geometry';
import type { Vec3 } from '../../view/types';
import type { Document } from '../document';
import type { EvaluatorPort } from '../evaluated';
import { t } from '../i18n';
import type { Pose } from '../pose';
import type { DeformService } from './api';
import type { DeformState } from './state';

export class DeformActions implements DeformService {
  constructor(
    private readonly document: Document,
    private readonly evaluator: Pick<EvaluatorPort, 'result'>,
    private readonly own: Pick<DeformState, 'step'>,
  ) {}

  setRoi(roi: VertexSet): void {
    this.#edit(t('history.roi'), (recipe, { id }) => edits.setRoi(recipe, id, roi as DeformStep['roi']));
  }

  setMethod(method: DeformStep['method']): void {
    this.#edit(t('history.method'), (recipe, { id }) => edits.setMethod(recipe, id, method));
  }

  setOptions(options: Partial<DeformStep['options']>): void {
    const merge = `options:${Object.keys(options).join()}`;
    this.#edit(
      t('history.options'),
      (recipe, { id }) => edits.setDeformOptions(recipe, id, options),
      undefined,
      merge,
    );
  }

  handleName(index: number): string {
    return this.step?.handles[index]?.name ?? t('handle.name', { number: index + 1 });
  }

  handleSize(handle: DeformHandle): number {
    if (handle.vertices === 'all') return (this.#rest?.length ?? 0) / 3;
    if ('ranges' in handle.vertices)
      return handle.vertices.ranges.reduce((sum, [first, last]) => sum + last - first + 1, 0);
    return handle.vertices.length;
  }

  rename(index: number, name: string): void {
    const label = t('history.rename-handle', { name: this.handleName(index) });
    this.#update(label, index, { name: name.trim().slice(0, 64) || undefined } as edits.HandlePatch);
  }

  hide(index: number, hidden: boolean): void {
    const name = this.handleName(index);
    const label = hidden ? t('history.hide-handle', { name }) : t('history.show-handle', { name });
    this.#update(label, index, { hidden: hidden || undefined } as edits.HandlePatch);
  }

  remove(index: number): void {
    const label = t('history.remove-handle', { name: this.handleName(index) });
    this.#edit(label, (recipe, { id }) => edits.removeHandle(recipe, id, index), null);
  }

  reset(index: number): void {
    const handle = this.#handle(index);
    const rest = this.#rest;
    if (!handle || !rest || atRest(handle, rest)) return;
    this.#replace(t('history.reset-handle', { name: this.handleName(index) }), index, toRest(handle, rest));
  }

  pose(index: number): Pose | undefined {
    const handle = this.#shownHandle(index);
    const rest = this.#rest;
    if (!handle || !rest) return undefined;
    return handle.kind === 'region'
      ? decompose(handle.matrix, pivotOf(handle, rest))
      : { ...STILL, translation: subtract(handle.position, pointAt(rest, handle.vertices[0]!)) };
  }

  setPose(index: number, pose: Partial<Pose>, live = false): void {
    const handle = this.#handle(index);
    const rest = this.#rest;
    const { step } = this;
    const values = Object.values(pose).flat() as number[];
    if (!handle || !rest || !step || !values.every(Number.isFinite)) return;
    const placed = withPose(handle, rest, pose);
    if (!live) {
      this.#replace(this.#poseLabel(index), index, placed, `pose:${index}`);
      return;
    }
    const recipe = edit.replaceStep(this.document.recipe, withHandle(step, index, placed));
    this.document.preview(recipe, { step: step.id, item: index });
  }

  finish(): void {
    this.document.finish(this.#poseLabel(this.document.selection.item ?? 0));
  }

  cancel(): void {
    this.document.cancel();
  }

  applyAndContinue(): void {
    const { recipe } = this.document;
    const { step } = this;
    if (!step) return;
    const id = edit.freeId('deform', recipe);
    const next = newDeformStep(id, step.id);
    const at = recipe.steps.indexOf(step) + 1;
    // What was built on the open step is built on the new one from now on.
    const later = edit.redirect({ ...recipe, steps: recipe.steps.slice(at) }, step.id, id).steps;
    const steps = [
      ...recipe.steps.slice(0, at),
      { ...next, method: step.method, options: step.options },
      ...later,
    ];
    this.document.commit(t('history.apply'), { ...recipe, steps }, { step: id, item: null });
  }

  /** The committed open step while it is one that deforms. */
  get step(): DeformStep | undefined {
    return edit.stepOf(this.document.recipe, this.document.selection.step, 'deform');
  }

  get #rest(): Float64Array | undefined {
    return this.evaluator.result.value?.shown.model.positions;
  }

  #handle(index: number): DeformHandle | undefined {
    return this.step?.handles[index];
  }

  #shownHandle(index: number): DeformHandle | undefined {
    return this.own.step.value?.handles[index];
  }

  #poseLabel = (index: number): string => t('history.pose-handle', { name: this.handleName(index) });

  #update(label: string, index: number, patch: edits.HandlePatch): void {
    this.#edit(label, (recipe, { id }) => edits.updateHandle(recipe, id, index, patch));
  }

  #replace(label: string, index: number, handle: DeformHandle, merge?: string): void {
    this.#edit(
      label,
      (recipe, step) => edit.replaceStep(recipe, withHandle(step, index, handle)),
      index,
      merge,
    );
  }

  /** @param item  selected afterwards; as before when left out */
  #edit(
    label: string,
    change: (recipe: Recipe, step: DeformStep) => Recipe,
    item?: number | null,
    merge?: string,
  ): void {
    const { recipe, selection } = this.document;
    const { step } = this;
    if (!step) return;
    const changed = change(recipe, step);
    const after = item === undefined || item === selection.item ? selection : { ...selection, item };
    if (changed !== recipe) this.document.commit(label, changed, after, merge);
  }
}

const STILL: Parts = { translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] };

const pivotOf = (handle: DeformHandle, rest: Float64Array): Vec3 =>
  centroid(rest, toIndices(handle.vertices, rest.length / 3));

/** The handle at a pose; parts left out stay, and a pure move keeps whatever else the matrix does. */
export function withPose(handle: DeformHandle, rest: Float64Array, pose: Partial<Pose>): DeformHandle {
  if (handle.kind === 'point') {
    const at = pointAt(rest, handle.vertices[0]!);
    const by = pose.translation ?? subtract(handle.position, at);
    return { ...handle, position: [at[0] + by[0], at[1] + by[1], at[2] + by[2]] };
  }
  const pivot = pivotOf(handle, rest);
  const parts = decompose(handle.matrix, pivot);
  if (pose.rotation || pose.scale) return { ...handle, matrix: [...compose({ ...parts, ...pose }, pivot)] };
  if (!pose.translation) return handle;
  const by = subtract(pose.translation, parts.translation);
  return { ...handle, matrix: [...multiply(translation(by), handle.matrix)] };
}
