// A drag that the graphics card moves the model by: it is given the motion once, then a small table a move.

import { effect, type Signal } from '@preact/signals';
import { MOTION } from '../view/motion/motion-layer';
import type { MotionPort, SurfaceMotion } from '../view/motion/types';
import type { ViewportPort } from '../view/types';
import type { EvaluatorPort } from './evaluated';

/** What a wing whose drags go so knows of it. */
export interface Moving {
  /** Whether the graphics card can move the model. */
  readonly movable: Signal<boolean>;
  /** For tests: what the graphics card makes of the model, see `MotionPort`. */
  readBack: MotionPort['readBack'];
}

/** @returns the function that ends it */
export function syncMotion(
  viewport: ViewportPort,
  { result }: Pick<EvaluatorPort, 'result'>,
  own: Moving,
): () => void {
  const { port, unmount } = viewport.mount(MOTION);
  let held: SurfaceMotion | null = null;
  let model: object | null = null;
  /** On screen when the card could not hold a motion: the next one may be smaller. */
  let tooMuch: object | null = null;
  const { movable } = own;
  movable.value = true;
  own.readBack = () => port.readBack();
  const stop = effect(() => {
    const shown = result.value;
    const moved = shown?.moved ?? null;
    if (tooMuch && shown && shown.shown.opened !== tooMuch) {
      tooMuch = null;
      movable.value = true;
    }
    if (!shown || !moved) {
      port.arrive();
      return;
    }
    // With another model on screen the card has let go of the motion.
    if (held !== moved.motion || model !== shown.shown.opened) {
      held = moved.motion;
      model = shown.shown.opened;
      if (!port.setMotion(held)) {
        tooMuch = model;
        movable.value = false;
      }
    }
    port.move(moved.table);
  });
  return () => {
    stop();
    movable.value = false;
    own.readBack = () => null;
    unmount();
  };
}
