// A drag by isolines on screen: the graphics card is given the surface once, then a few numbers a move.

import { effect } from '@preact/signals';
import { BLEND } from '../../view/blend/blend-layer';
import type { BlendSurface } from '../../view/blend/types';
import type { ViewportPort } from '../../view/types';
import type { EvaluatorPort } from '../evaluated';
import type { DeformState } from './state';

/** @returns the function that ends it */
export function syncBlend(
  viewport: ViewportPort,
  { result }: Pick<EvaluatorPort, 'result'>,
  own: Pick<DeformState, 'blends' | 'readBack'>,
): () => void {
  const { port, unmount } = viewport.mount(BLEND);
  let held: BlendSurface | null = null;
  let model: object | null = null;
  /** On screen when the card could not hold a surface: the next one may be smaller. */
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
    // With another model on screen the card has let go of the surface.
    if (held !== blend.surface || model !== shown.shown.opened) {
      held = blend.surface;
      model = shown.shown.opened;
      if (!port.setSurface(held)) {
        tooMuch = model;
        blends.value = false;
      }
    }
    port.move(blend.offsets);
  });
  return () => {
    stop();
    blends.value = false;
    own.readBack = () => null;
    unmount();
  };
}
