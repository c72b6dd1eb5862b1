// The app's side of the deform tools: the scene they read, the edits they make.

import { signal } from '@preact/signals';
import { replaceStep, stepOf } from '../../recipe/edit';
import type { DeformStep } from '../../recipe/recipe';
import type { Brush, Paint } from '../../tools/brush-stroke';
import type { DeformEdit, DeformHost, DeformScene, EditLabel } from '../../tools/deform/host';
import type { MarkersPort } from '../../view/overlays/types';
import type { ViewportPort } from '../../view/types';
import { t } from '../i18n';
import { brushOf, SurfaceAids } from '../surface-aids';
import type { WingParts } from '../wing-parts';

export class AppDeformHost implements DeformHost {
  /** The stroke under way. */
  readonly paint = signal<Paint | null>(null);
  readonly #aids = new SurfaceAids();

  constructor(
    readonly view: ViewportPort,
    readonly markers: MarkersPort,
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'evaluator'>,
  ) {}

  scene(): DeformScene | null {
    const { document, evaluator, state } = this.parts;
    const { recipe, selection } = document;
    const step = stepOf(recipe, selection.step, 'deform');
    const evaluation = evaluator.result.peek();
    if (!step || evaluation?.step.id !== step.id) return null;
    const { shown, positions } = evaluation;
    return {
      step,
      selected: selection.item,
      rest: shown.model.positions,
      posed: positions,
      ...this.#aids.of(shown, state.mirror),
    };
  }

  brush(): Brush {
    return brushOf(this.parts.state);
  }

  newName(step: DeformStep): string {
    const taken = new Set(step.handles.map(({ name }) => name));
    for (let number = 1; ; number++) {
      const name = t('handle.name', { number });
      if (!taken.has(name)) return name;
    }
  }

  preview({ step, selected }: DeformEdit): void {
    const { document } = this.parts;
    document.preview(replaceStep(document.recipe, step), { step: step.id, item: selected });
  }

  commit(label: EditLabel, { step, selected }: DeformEdit): void {
    const name = step.handles[selected ?? -1]?.name ?? '';
    const { document } = this.parts;
    const recipe = replaceStep(document.recipe, step);
    document.commit(t(`history.${label}`, { name }), recipe, { step: step.id, item: selected });
  }

  cancel(): void {
    this.parts.document.cancel();
  }

  select(handle: number | null): void {
    this.parts.document.select(handle);
  }

  showPaint(paint: Paint | null): void {
    this.paint.value = paint;
  }
}
