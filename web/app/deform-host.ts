// The app's side of the deform tools: the scene they read, the edits they make.

import { signal } from '@preact/signals';
import type { DeformStep } from '../recipe/recipe';
import type { ModelResult } from '../run/types';
import type { Brush, Paint } from '../tools/brush-stroke';
import type { DeformEdit, DeformHost, DeformScene, EditLabel } from '../tools/deform/host';
import { MeshGraph } from '../tools/mesh-graph';
import { Mirror } from '../tools/mirror';
import type { MarkersPort } from '../view/overlays/types';
import type { ViewportPort } from '../view/types';
import { replaceStep } from './deform-actions';
import type { Document } from './document';
import type { Evaluator } from './evaluation';
import { t } from './i18n';
import type { State } from './state';

export class AppDeformHost implements DeformHost {
  /** The stroke under way. */
  readonly paint = signal<Paint | null>(null);
  #aids: Aids | null = null;

  constructor(
    readonly view: ViewportPort,
    readonly markers: MarkersPort,
    private readonly state: State,
    private readonly document: Document,
    private readonly evaluator: Pick<Evaluator, 'result'>,
  ) {}

  scene(): DeformScene | null {
    const { step, selection } = this.document;
    const evaluation = this.evaluator.result.peek();
    if (!step || evaluation?.step.id !== step.id) return null;
    const { input, positions } = evaluation;
    const aids = this.#aidsFor(input);
    return {
      step,
      selected: selection.handle,
      rest: input.model.positions,
      posed: positions,
      graph: aids.graph,
      mirrored: (vertices) => (this.state.mirror.peek() ? aids.mirror.both(vertices) : vertices),
    };
  }

  brush(): Brush {
    return { radius: this.state.brushSize.peek(), erase: this.state.brushMode.peek() === 'erase' };
  }

  newName(step: DeformStep): string {
    const taken = new Set(step.handles.map(({ name }) => name));
    for (let number = 1; ; number++) {
      const name = t('handle.name', { number });
      if (!taken.has(name)) return name;
    }
  }

  preview({ step, selected }: DeformEdit): void {
    this.document.preview(replaceStep(this.document.recipe, step), { step: step.id, handle: selected });
  }

  commit(label: EditLabel, { step, selected }: DeformEdit): void {
    const name = step.handles[selected ?? -1]?.name ?? '';
    const recipe = replaceStep(this.document.recipe, step);
    this.document.commit(t(`history.${label}`, { name }), recipe, { step: step.id, handle: selected });
  }

  cancel(): void {
    this.document.cancel();
  }

  select(handle: number | null): void {
    this.document.select(handle);
  }

  showPaint(paint: Paint | null): void {
    this.paint.value = paint;
  }

  #aidsFor(input: ModelResult): Aids {
    if (this.#aids?.input !== input) this.#aids = new Aids(input);
    return this.#aids;
  }
}

/** What is worked out once per model, when a tool first needs it. */
class Aids {
  #graph: MeshGraph | undefined;
  #mirror: Mirror | undefined;

  constructor(readonly input: ModelResult) {}

  get graph(): MeshGraph {
    this.#graph ??= new MeshGraph(this.input.opened);
    return this.#graph;
  }

  get mirror(): Mirror {
    this.#mirror ??= new Mirror(this.input.model.positions);
    return this.#mirror;
  }
}
