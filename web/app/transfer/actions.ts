// What panels, commands and tools ask of the open transfer step; each edit is one step of undo, except previews.

import { sizeOf } from '../../core/vertex-set';
import * as edit from '../../recipe/edit';
import type { DeformStep, TransferStep } from '../../recipe/recipe';
import type { PaintVerb } from '../../tools/paint-tool';
import { nextOpen, pairing, setCounterpart } from '../../tools/transfer/edits';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import { TransferEdits } from './edits';
import type { Follow } from './follow';
import { pairedByName, poseOf, posesFor, withPose } from './poses';
import type { TransferState } from './state';
import { TargetChoice } from './target-choice';

/** One handle of the pose, and what it meets on the other model. */
export interface PairRow {
  readonly index: number;
  readonly name: string;
  readonly isPoint: boolean;
  /** Vertices on the two models; 0: none. */
  readonly source: number;
  readonly target: number;
}

export class TransferActions {
  readonly edits: TransferEdits;
  readonly target: TargetChoice;

  constructor(
    private readonly parts: WingParts,
    private readonly own: TransferState,
    follow: Follow,
  ) {
    this.edits = new TransferEdits(parts.document);
    this.target = new TargetChoice(parts, own, follow);
  }

  /** The pose that the open step is to give. Reads signals. */
  pose(): DeformStep | undefined {
    const step = this.own.step.value;
    return step && poseOf(this.parts.state.recipe.value, step);
  }

  /** Whether the open step's pose goes from skin to skin, and nothing is paired. Reads signals. */
  isThrough(): boolean {
    return this.own.step.value?.through !== undefined;
  }

  /** Reads signals. */
  poses(): readonly DeformStep[] {
    return posesFor(this.parts.state.recipe.value, this.own.step.value);
  }

  handleName(index: number, pose = this.pose()): string {
    return pose?.handles[index]?.name ?? t('transfer.handle', { number: index + 1 });
  }

  /** Reads signals. */
  rows(): readonly PairRow[] {
    const pose = this.pose();
    const step = this.own.step.value;
    if (!pose || !step) return [];
    const sources = (this.own.source.value?.rest.model.positions.length ?? 0) / 3;
    return pose.handles.map(({ kind, vertices }, index) => ({
      index,
      name: this.handleName(index, pose),
      isPoint: kind === 'point',
      source: sizeOf(vertices, sources),
      target: sizeOf(step.handles[index] ?? [], this.#count),
    }));
  }

  /** Numbers of handles that have no counterpart yet. Reads signals. */
  open(): readonly number[] {
    const pose = this.pose();
    const step = this.own.step.value;
    return pose && step ? pairing(step, pose.handles).open : [];
  }

  /** Takes up a handle to say what meets it. */
  pick(index: number): void {
    const { state, document } = this.parts;
    document.select(index);
    state.tool.value = 'paint-pair';
  }

  pickNext(): void {
    const next = nextOpen(this.open(), this.parts.document.selection.item);
    if (next !== null) this.pick(next);
  }

  setCounterpart(index: number, vertices: Uint32Array, verb: PaintVerb | 'clear'): void {
    const { step } = this.edits;
    const pose = step && poseOf(this.parts.document.recipe, step);
    if (!step || !pose || index >= pose.handles.length) return;
    const full = { ...step, handles: pose.handles.map((_, i) => step.handles[i] ?? []) };
    const label = t(`history.transfer.${verb}`, { name: this.handleName(index, pose) });
    this.edits.commit(label, setCounterpart(full, index, vertices, this.#count), index);
  }

  clear(index: number): void {
    this.setCounterpart(index, new Uint32Array(), 'clear');
  }

  /** Reads signals. @returns the very same step where nothing is known by name */
  byName(step: TransferStep): TransferStep {
    return pairedByName(this.parts.state.recipe.value, step, this.#count);
  }

  pairByName(): void {
    const { step } = this.edits;
    if (step) this.edits.commit(t('history.transfer.by-name'), this.byName(step));
  }

  /** Lets the pose's handles and the counterparts be as many again; those that are too many go. */
  fitHandles(): void {
    const { step } = this.edits;
    const pose = step && poseOf(this.parts.document.recipe, step);
    if (!step || !pose) return;
    const handles = pose.handles.map((_, i) => step.handles[i] ?? []);
    this.edits.commit(t('history.transfer.fit'), { ...step, handles }, null);
  }

  setStrength(strength: number, live = false): void {
    const { step } = this.edits;
    if (!step) return;
    const label = t('history.transfer.strength');
    if (live) this.edits.preview(label, { ...step, strength });
    else this.edits.commit(label, { ...step, strength });
  }

  setKeepStretch(keepStretch: boolean): void {
    const { step } = this.edits;
    if (step) this.edits.commit(t('history.transfer.stretch'), { ...step, keepStretch });
  }

  choosePose(id: string): void {
    const { document } = this.parts;
    const { step } = this.edits;
    const pose = edit.stepOf(document.recipe, id, 'deform');
    if (!step || !pose || step.like === id) return;
    const recipe = withPose(document.recipe, step, pose);
    document.commit(t('history.transfer.pose', { name: id }), recipe, { step: step.id, item: null });
  }

  editPose(): void {
    const { step } = this.edits;
    if (step) this.parts.document.openStep(step.like);
  }

  /** A copy of the pose to be changed, which the open step gives from now on. */
  newPose(): void {
    const { document } = this.parts;
    const { step } = this.edits;
    const pose = step && poseOf(document.recipe, step);
    if (!step || !pose) return;
    const { recipe } = document;
    const copy = { ...pose, id: edit.freeId('deform', recipe) };
    const steps = recipe.steps.flatMap((each) => {
      if (each === pose) return [pose, copy];
      return each === step ? [{ ...step, like: copy.id }] : [each];
    });
    document.commit(t('history.transfer.new-pose'), { ...recipe, steps }, { step: copy.id, item: null });
  }

  /** Vertices of the model that gets the pose. */
  get #count(): number {
    return (this.parts.evaluator.result.value?.shown.model.positions.length ?? 0) / 3;
  }
}
