// The app's side of the transfer tools: the model they pair parts of, the edits they make.

import { signal } from '@preact/signals';
import type { Brush, Paint } from '../../tools/brush-stroke';
import type { PaintVerb } from '../../tools/paint-tool';
import type { TransferHost, TransferScene } from '../../tools/transfer/host';
import type { ViewportPort } from '../../view/types';
import { brushOf, SurfaceAids } from '../surface-aids';
import type { WingParts } from '../wing-parts';
import type { TransferActions } from './actions';
import { poseOf } from './poses';

export class AppTransferHost implements TransferHost {
  /** The stroke under way. */
  readonly paint = signal<Paint | null>(null);
  readonly #aids = new SurfaceAids();

  constructor(
    readonly view: ViewportPort,
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'evaluator'>,
    private readonly actions: TransferActions,
  ) {}

  scene(): TransferScene | null {
    const { document, evaluator, state } = this.parts;
    const { step } = this.actions.edits;
    const evaluation = evaluator.result.peek();
    const pose = step && poseOf(document.recipe, step);
    if (!step || !pose || state.choosing.peek() || evaluation?.step.id !== step.id) return null;
    const { shown } = evaluation;
    return {
      step,
      handles: pose.handles,
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

  commit(verb: PaintVerb, handle: number, vertices: Uint32Array): void {
    this.actions.setCounterpart(handle, vertices, verb);
  }

  pick(handle: number): void {
    this.actions.pick(handle);
  }
}
