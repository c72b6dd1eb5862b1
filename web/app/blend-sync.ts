// A drag that the graphics card moves the model by: it is given the motion once, then a small table a move.

import { effect, type Signal } from '@preact/signals';
import { BLEND } from '../view/blend/blend-layer';
import type { BlendPort, SurfaceMotion } from '../view/blend/types';
import type { ViewportPort } from '../view/types';
import type { EvaluatorPort } from './evaluated';

/** What a wing whose drags go so knows of it. */
export interface Blending {
  /** Whether the graphics card can move the model. */
  readonly blends: Signal<boolean>;
  /** For tests: what the graphics card makes of the model, see `BlendPort`. */
  readBack: BlendPort['readBack'];
}

/** @returns the function that ends it */
export function syncBlend(
  viewport: ViewportPort,
  { result }: Pick<EvaluatorPort, 'result'>,
  own: Blending,
): () => void {
  const { port, unmount } = viewport.mount(BLEND);
  let held: SurfaceMotion | null = null;
  let model: object | null = null;
  /** On screen when the card could not hold a motion: the next one may be smaller. */
  let tooMuch: object | null = null;
  const { blends } = own;
  blends.value = true;
  own.readBack = () => port.readBack();
  const stop = effect(() => {
    const shown = result.value;
    const blend = shown?.blend ?? null;
    if (tooMuch && shown && shown.shown.opened !== tooMuch) {
      tooMuch = null;
      blends.value = true;
    }
    if (!shown || !blend) {
      port.arrive();
      return;
    }
    // With another model on screen the card has let go of the motion.
    if (held !== blend.motion || model !== shown.shown.opened) {
      held = blend.motion;
      model = shown.shown.opened;
      if (!port.setMotion(held)) {
        tooMuch = model;
        blends.value = false;
      }
    }
    port.move(blend.table);
  });
  return () => {
    stop();
    blends.value = false;
    own.readBack = () => null;
    unmount();
  };
}
