// The app's side of the blend tools: the skin they mark parts of, the edits they make.

import { signal } from '@preact/signals';
import type { BlendHost, BlendScene, Length } from '../../tools/blend/host';
import type { Brush, Paint } from '../../tools/brush-stroke';
import type { PaintVerb } from '../../tools/paint-tool';
import type { ViewportPort } from '../../view/types';
import { brushOf, SurfaceAids } from '../surface-aids';
import type { WingParts } from '../wing-parts';
import type { BlendActions } from './actions';
import type { BlendState } from './state';

export class AppBlendHost implements BlendHost {
  /** The stroke under way. */
  readonly paint = signal<Paint | null>(null);
  readonly #aids = new SurfaceAids();

  constructor(
    readonly view: ViewportPort,
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'evaluator'>,
    private readonly actions: BlendActions,
    private readonly own: BlendState,
  ) {}

  scene(): BlendScene | null {
    const { document, evaluator, state } = this.parts;
    const { step } = this.actions.edits;
    const evaluation = evaluator.result.peek();
    if (!step || evaluation?.step.id !== step.id || !evaluation.report) return null;
    const { shown } = evaluation;
    return {
      step,
      count: shown.model.positions.length / 3,
      selected: document.selection.item,
      ...this.#aids.of(shown, state.mirror),
    };
  }

  brush(): Brush {
    return brushOf(this.parts.state);
  }

  showPaint(paint: Paint | null): void {
    this.paint.value = paint;
  }

  commit(verb: PaintVerb, part: number | null, vertices: Uint32Array): void {
    this.actions.setVertices(part, vertices, verb);
  }

  pick(part: number | null): void {
    this.parts.document.select(part);
  }

  measure(vertex: number): void {
    this.actions.measuring.addGirth(vertex);
  }

  lengthFrom(): number | null {
    return this.own.length.peek()?.from ?? null;
  }

  beginLength(vertex: number): void {
    this.own.length.value = { from: vertex, to: null, straight: false };
  }

  showLength(length: Length | null): void {
    const begun = this.own.length.peek();
    if (begun) this.own.length.value = length ?? { ...begun, to: null };
  }

  measureLength(from: number, to: number, straight: boolean): void {
    this.actions.measuring.addLength(from, to, straight);
  }
}
