// Edits of the open hair step that panels and commands ask for; each is one step of undo.

import * as edit from '../../recipe/edit';
import type { HairStep } from '../../recipe/recipe';
import { scalpOf } from '../../run/steps/hair/scalp';
import { duplicatePrimitive, removePrimitive, replacePrimitive } from '../../tools/hair/edits';
import type { HairScene } from '../../tools/hair/host';
import { type Primitive, type PrimitivePatch, primitiveAt, primitivesOf } from '../../tools/hair/style';
import { viewpointOf } from '../../tools/stroke/support';
import { t } from '../i18n';
import { LiveEdit } from '../live-edit';
import type { WingParts } from '../wing-parts';
import type { HairPatch, HairService } from './api';
import { headHeight } from './head-height';
import { fitted } from './refit';
import type { HairState } from './state';

type Parts = Pick<WingParts, 'state' | 'document' | 'evaluator' | 'models' | 'viewport'>;

export class HairActions implements HairService {
  readonly #live: LiveEdit;

  constructor(
    private readonly parts: Parts,
    private readonly own: HairState,
  ) {
    this.#live = new LiveEdit(parts.document);
  }

  select(primitive: number | null): void {
    const { document } = this.parts;
    if (primitive !== null && primitive !== document.selection.item) this.rebuildSupport();
    document.select(primitive);
  }

  primitiveName(index: number): string {
    const step = this.own.step.value;
    const primitive = step && primitiveAt(step, index);
    if (!primitive) return '';
    if (primitive.item.name) return primitive.item.name;
    const before = primitivesOf(step).slice(0, index + 1);
    const number = before.filter(({ kind }) => kind === primitive.kind).length;
    return t(`hair.name.${primitive.kind}`, { number });
  }

  rename(index: number, name: string): void {
    const label = t('history.hair.rename', { name: this.primitiveName(index) });
    this.#label(label, index, { name: name.trim().slice(0, 64) || undefined });
  }

  hide(index: number, hidden: boolean): void {
    const name = this.primitiveName(index);
    const label = hidden ? t('history.hair.hide', { name }) : t('history.hair.show', { name });
    this.#label(label, index, { hidden: hidden || undefined });
  }

  remove(index: number): void {
    const scene = this.#scene;
    if (!scene || !primitiveAt(scene.step, index)) return;
    const label = t('history.hair.remove', { name: this.primitiveName(index) });
    const { step, selected } = removePrimitive(scene, index);
    this.#commit(label, step, selected);
  }

  duplicate(index: number): void {
    const scene = this.#scene;
    if (!scene || !primitiveAt(scene.step, index)) return;
    const label = t('history.hair.duplicate', { name: this.primitiveName(index) });
    const { step, selected } = duplicatePrimitive(scene, index);
    this.#commit(label, step, selected);
  }

  setPrimitive(index: number, patch: PrimitivePatch, live = false): void {
    const scene = this.#scene;
    const primitive = scene && primitiveAt(scene.step, index);
    if (!primitive) return;
    const item = { ...primitive.item, ...patch };
    const { step, selected } = replacePrimitive(scene, index, { kind: primitive.kind, item } as Primitive);
    const label = t('history.hair.options', { name: this.primitiveName(index) });
    this.#apply(label, step, selected, live, `primitive:${index}:${Object.keys(patch)}`);
  }

  update(patch: HairPatch, live = false): void {
    const step = this.#step;
    if (!step) return;
    const next = patched(step, patch);
    const keys = Object.entries(patch).map(([group, fields]) => `${group}:${Object.keys(Object(fields))}`);
    const label = 'material' in patch ? t('history.hair.look') : t('history.hair.change');
    this.#apply(label, next, this.parts.document.selection.item, live, keys.join());
  }

  finish(): void {
    this.#live.finish();
  }

  cancel(): void {
    this.#live.cancel();
  }

  newSeed(): void {
    const step = this.#step;
    // The next of a fixed walk, so that the same presses give the same hair.
    if (step) this.update({ strands: { seed: (step.strands.seed * 48271 + 11) % 2147483647 } });
  }

  async setHead(builtin: string): Promise<void> {
    const { document, models, evaluator } = this.parts;
    const step = this.#step;
    const before = evaluator.result.peek()?.shown.model;
    if (!step || !before || step.model === builtin) return;
    const head = (await models.read({ builtin })).model;
    const { scalp: _, ...bare } = fitted(step, { model: before, scalp: scalpOf(step, before) }, head);
    const named = edit.setModel(document.recipe, builtin, { builtin });
    const recipe = edit.pruneModels(edit.replaceStep(named, { ...bare, model: builtin }));
    document.commit(t('history.hair.head'), recipe, { step: step.id, item: document.selection.item });
  }

  scalpSize(): number {
    const evaluation = this.parts.evaluator.result.value;
    const step = this.own.step.value;
    return step && evaluation ? scalpOf(step, evaluation.shown.model).length : 0;
  }

  headHeight(): number {
    const evaluation = this.parts.evaluator.result.value;
    if (evaluation?.step.type !== 'hair') return 1;
    return headHeight(evaluation) || 1;
  }

  rebuildSupport(): void {
    const { viewport } = this.parts;
    if (viewport) this.own.viewpoint.value = viewpointOf(viewport.camera);
  }

  get #step(): HairStep | undefined {
    const { document } = this.parts;
    return edit.stepOf(document.recipe, document.selection.step, 'hair');
  }

  get #scene(): HairScene | undefined {
    const step = this.#step;
    if (!step) return undefined;
    const { document, state } = this.parts;
    return {
      step,
      selected: document.selection.item,
      height: this.headHeight(),
      mirror: state.mirror.peek(),
    };
  }

  /** Name and hiding: of this one alone, whatever the mirror says. */
  #label(
    label: string,
    index: number,
    patch: { name?: string | undefined } | { hidden?: boolean | undefined },
  ) {
    const scene = this.#scene;
    const primitive = scene && primitiveAt(scene.step, index);
    if (!primitive) return;
    const item = withoutUndefined({ ...primitive.item, ...patch });
    const alone = { ...scene, mirror: false };
    const { step } = replacePrimitive(alone, index, { kind: primitive.kind, item } as Primitive);
    this.#commit(label, step, scene.selected);
  }

  #apply(label: string, step: HairStep, selected: number | null, live: boolean, merge: string): void {
    const { document } = this.parts;
    if (live)
      this.#live.preview(label, edit.replaceStep(document.recipe, step), { step: step.id, item: selected });
    else this.#commit(label, step, selected, merge);
  }

  #commit(label: string, step: HairStep, item: number | null, merge?: string): void {
    const { document } = this.parts;
    document.commit(label, edit.replaceStep(document.recipe, step), { step: step.id, item }, merge);
  }
}

/** The step with some fields of its groups set; one that is `undefined` is left to its default. */
function patched(step: HairStep, patch: HairPatch): HairStep {
  const out: Record<string, unknown> = { ...step };
  for (const [field, value] of Object.entries(patch)) {
    const group = step[field as keyof HairPatch];
    out[field] = typeof group === 'object' ? withoutUndefined({ ...group, ...Object(value) }) : value;
  }
  return withoutUndefined(out) as HairStep;
}

const withoutUndefined = <T extends object>(value: T): T =>
  Object.fromEntries(Object.entries(value).filter(([, held]) => held !== undefined)) as T;
