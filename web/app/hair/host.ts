// The app's side of the hair tools: the head and style they read, the edits they make.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { fromIndices } from '../../core/vertex-set';
import { replaceStep, stepOf } from '../../recipe/edit';
import type { HairStep } from '../../recipe/recipe';
import { scalpOf } from '../../run/steps/hair/scalp';
import type { Brush, Paint } from '../../tools/brush-stroke';
import type { HairEdit, HairEditLabel, HairHost, HairRemark, HairScene } from '../../tools/hair/host';
import { REACH } from '../../tools/hair/measures';
import type { ScalpHost, ScalpScene } from '../../tools/hair/scalp-tool';
import { mainPart, pointsOf, primitiveAt } from '../../tools/hair/style';
import type { PaintVerb } from '../../tools/paint-tool';
import { SupportSurface, viewpointOf } from '../../tools/stroke/support';
import { t } from '../i18n';
import { brushOf, SurfaceAids } from '../surface-aids';
import type { WingParts } from '../wing-parts';
import { headHeight } from './head-height';
import type { HairState, ShownStroke } from './state';

type Parts = Pick<WingParts, 'state' | 'document' | 'evaluator' | 'messages'>;

export class AppHairHost implements HairHost, ScalpHost {
  /** Of the selected curve as shown, rebuilt as it changes. */
  readonly surface: ReadonlySignal<SupportSurface | null>;
  /** The scalp while it is being painted. */
  readonly paint = signal<Uint32Array | null>(null);
  readonly #aids = new SurfaceAids();

  constructor(
    readonly view: HairHost['view'] & ScalpHost['view'],
    readonly curves: HairHost['curves'],
    private readonly parts: Parts,
    private readonly own: HairState,
  ) {
    this.surface = computed(() => this.#build());
  }

  scene(): HairScene | null {
    const { document, state } = this.parts;
    const { step } = this;
    const height = this.#height;
    if (!step || height === null) return null;
    return { step, selected: document.selection.item, height, mirror: state.mirror.peek() };
  }

  preview({ step, selected }: HairEdit): void {
    const { document } = this.parts;
    document.preview(replaceStep(document.recipe, step), { step: step.id, item: selected });
  }

  commit(label: HairEditLabel, { step, selected }: HairEdit): void {
    const { document } = this.parts;
    const recipe = replaceStep(document.recipe, step);
    document.commit(t(`history.hair.${label}`), recipe, { step: step.id, item: selected });
  }

  cancel(): void {
    this.parts.document.cancel();
  }

  select(primitive: number | null): void {
    if (primitive !== null && primitive !== this.parts.document.selection.item) this.rebuildSupport();
    this.parts.document.select(primitive);
  }

  support(): SupportSurface | null {
    return this.surface.peek();
  }

  rebuildSupport(): void {
    this.own.viewpoint.value = viewpointOf(this.view.camera);
  }

  showStroke(stroke: ShownStroke | null): void {
    this.own.stroke.value = stroke && { ...stroke, line: [...stroke.line] };
  }

  say(remark: HairRemark): void {
    this.parts.messages.toast('info', t(`hair.remark.${remark}`));
  }

  aim(onHead: boolean): void {
    this.own.aimed.value = onHead;
  }

  brush(): Brush {
    return brushOf(this.parts.state);
  }

  scalpScene(): ScalpScene | null {
    const { evaluator, state } = this.parts;
    const { step } = this;
    const evaluation = evaluator.result.peek();
    if (!step || evaluation?.step.id !== step.id) return null;
    const { shown } = evaluation;
    return { scalp: scalpOf(step, shown.model), ...this.#aids.of(shown, state.mirror) };
  }

  commitScalp(verb: PaintVerb, scalp: Uint32Array): void {
    const { document, evaluator } = this.parts;
    const { step } = this;
    const count = (evaluator.result.peek()?.shown.model.positions.length ?? 0) / 3;
    if (!step) return;
    const painted = { ...step, scalp: fromIndices(scalp, count) };
    document.commit(t(`history.hair.${verb}-scalp`), replaceStep(document.recipe, painted));
  }

  showPaint(paint: Paint | null): void {
    this.paint.value = paint?.vertices ?? null;
  }

  /** The committed open step while it is one that grows hair. */
  get step(): HairStep | undefined {
    const { document } = this.parts;
    return stepOf(document.recipe, document.selection.step, 'hair');
  }

  get #height(): number | null {
    const evaluation = this.parts.evaluator.result.peek();
    return evaluation?.step.type === 'hair' ? headHeight(evaluation) : null;
  }

  #build(): SupportSurface | null {
    const { state, evaluator } = this.parts;
    const step = this.own.step.value;
    const evaluation = evaluator.result.value;
    const primitive = step && primitiveAt(step, state.selection.value.item);
    const viewpoint = this.own.viewpoint.value ?? viewpointOf(this.view.camera);
    if (!primitive || evaluation?.step.type !== 'hair') return null;
    const line = pointsOf(primitive, mainPart(primitive));
    if (line.length < 2) return null;
    const reach = REACH * headHeight(evaluation);
    return new SupportSurface(line, viewpoint, this.own.supportKind.value, reach);
  }
}
