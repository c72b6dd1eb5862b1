// The app's side of the hair tools: the head and style they read, the edits they make.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { fromIndices } from '../../core/vertex-set';
import type { HairStep } from '../../recipe/recipe';
import type { ModelResult } from '../../run/types';
import type { Brush } from '../../tools/brush-stroke';
import type { HairEdit, HairEditLabel, HairHost, HairRemark, HairScene } from '../../tools/hair/host';
import { REACH } from '../../tools/hair/measures';
import type { ScalpHost, ScalpScene } from '../../tools/hair/scalp-tool';
import { mainPart, pointsOf, primitiveAt } from '../../tools/hair/style';
import { SupportSurface, viewpointOf } from '../../tools/stroke/support';
import { MeshGraph } from '../../tools/mesh-graph';
import { Mirror } from '../../tools/mirror';
import type { PaintVerb } from '../../tools/paint-tool';
import type { RegionPaint, ViewportPort } from '../../view/types';
import type { MessageService } from '../api';
import type { Document } from '../document';
import type { Evaluator } from '../evaluation';
import { t } from '../i18n';
import type { State } from '../state';
import type { ShownStroke } from './state';
import { hairStepById, headHeight, scalpOf, withHairStep } from './steps';

interface Parts {
  readonly viewport: ViewportPort;
  readonly state: State;
  readonly document: Document;
  readonly evaluator: Pick<Evaluator, 'result'>;
  readonly messages: MessageService;
}

export class AppHairHost implements HairHost, ScalpHost {
  readonly view: ViewportPort;
  /** Of the selected curve as shown, rebuilt as it changes. */
  readonly surface: ReadonlySignal<SupportSurface | null>;
  /** The scalp while it is being painted. */
  readonly paint = signal<Uint32Array | null>(null);
  #aids: { readonly input: ModelResult; readonly graph: MeshGraph; readonly mirror: Mirror } | null = null;

  constructor(private readonly parts: Parts) {
    this.view = parts.viewport;
    this.surface = computed(() => this.#build());
  }

  scene(): HairScene | null {
    const { document, state } = this.parts;
    const step = hairStepById(document.recipe, document.selection.step);
    const height = this.#height;
    if (!step || height === null) return null;
    return { step, selected: document.selection.handle, height, mirror: state.mirror.peek() };
  }

  preview({ step, selected }: HairEdit): void {
    const { document } = this.parts;
    document.preview(withHairStep(document.recipe, step), { step: step.id, handle: selected });
  }

  commit(label: HairEditLabel, { step, selected }: HairEdit): void {
    const { document } = this.parts;
    const recipe = withHairStep(document.recipe, step);
    document.commit(t(`history.hair.${label}`), recipe, { step: step.id, handle: selected });
  }

  cancel(): void {
    this.parts.document.cancel();
  }

  select(primitive: number | null): void {
    if (primitive !== null && primitive !== this.parts.document.selection.handle) this.rebuildSupport();
    this.parts.document.select(primitive);
  }

  support(): SupportSurface | null {
    return this.surface.peek();
  }

  rebuildSupport(): void {
    this.parts.state.hair.viewpoint.value = viewpointOf(this.view.camera);
  }

  showStroke(stroke: ShownStroke | null): void {
    this.parts.state.hair.stroke.value = stroke && { ...stroke, line: [...stroke.line] };
  }

  say(remark: HairRemark): void {
    this.parts.messages.toast('info', t(`hair.remark.${remark}`));
  }

  aim(onHead: boolean): void {
    this.parts.state.hair.aimed.value = onHead;
  }

  brush(): Brush {
    const { state } = this.parts;
    return { radius: state.brushSize.peek(), erase: state.brushMode.peek() === 'erase' };
  }

  scalpScene(): ScalpScene | null {
    const { document, evaluator, state } = this.parts;
    const step = hairStepById(document.recipe, document.selection.step);
    const evaluation = evaluator.result.peek();
    if (!step || evaluation?.step.id !== step.id) return null;
    const { input } = evaluation;
    if (this.#aids?.input.opened !== input.opened)
      this.#aids = { input, graph: new MeshGraph(input.opened), mirror: new Mirror(input.model.positions) };
    const { graph, mirror } = this.#aids;
    return {
      scalp: scalpOf(step, input.model),
      graph,
      mirrored: (vertices) => (state.mirror.peek() ? mirror.both(vertices) : vertices),
    };
  }

  commitScalp(verb: PaintVerb, scalp: Uint32Array): void {
    const { document, evaluator } = this.parts;
    const step = hairStepById(document.recipe, document.selection.step);
    const count = (evaluator.result.peek()?.input.model.positions.length ?? 0) / 3;
    if (!step) return;
    const painted = { ...step, scalp: fromIndices(scalp, count) as NonNullable<HairStep['scalp']> };
    document.commit(t(`history.hair.${verb}-scalp`), withHairStep(document.recipe, painted));
  }

  showPaint(paint: Pick<RegionPaint, 'kind' | 'vertices'> | null): void {
    this.paint.value = paint?.vertices ?? null;
  }

  get #height(): number | null {
    const evaluation = this.parts.evaluator.result.peek();
    return evaluation?.step.type === 'hair' ? headHeight(evaluation.step, evaluation.input.model) : null;
  }

  #build(): SupportSurface | null {
    const { state, evaluator } = this.parts;
    const step = state.hairStep.value;
    const evaluation = evaluator.result.value;
    const primitive = step && primitiveAt(step, state.selection.value.handle);
    const viewpoint = state.hair.viewpoint.value ?? viewpointOf(this.view.camera);
    if (!primitive || evaluation?.step.type !== 'hair') return null;
    const line = pointsOf(primitive, mainPart(primitive));
    if (line.length < 2) return null;
    const reach = REACH * headHeight(evaluation.step, evaluation.input.model);
    return new SupportSurface(line, viewpoint, state.hair.supportKind.value, reach);
  }
}
