// Small pictures of the skins, for the corners of the triangle and the rows of the sliders.

import { effect } from '@preact/signals';
import type { ViewportPort } from '../../view/types';
import type { WingParts } from '../wing-parts';
import type { BlendState, Skins } from './state';

/** Twice what is shown, in pixels. */
export const SKIN_PICTURE = { width: 96, height: 96 } as const;
/** Ms of rest before pictures are made. */
const QUIET = 200;

/** @returns the function that ends it */
export function syncPictures(
  viewport: Pick<ViewportPort, 'thumbnail'>,
  { state, evaluator, messages }: Pick<WingParts, 'state' | 'evaluator' | 'messages'>,
  own: Pick<BlendState, 'skins' | 'pictures'>,
): () => void {
  let made: Skins | null = null;
  let wait: ReturnType<typeof setTimeout> | undefined;
  let run = 0;

  const clear = () => {
    for (const url of own.pictures.peek().values()) URL.revokeObjectURL(url);
    own.pictures.value = new Map();
  };
  const make = async (skins: Skins, turn: number) => {
    const pictures = new Map<string, string>();
    for (const [k, name] of skins.names.entries()) {
      // What is on screen may be another model by now.
      if (turn !== run || evaluator.result.peek()?.shown.opened !== skins.skin.opened) break;
      const picture = await viewport.thumbnail(skins.positions[k]!, SKIN_PICTURE.width, SKIN_PICTURE.height);
      pictures.set(name, URL.createObjectURL(picture));
    }
    if (turn === run && pictures.size === skins.names.length) {
      clear();
      own.pictures.value = pictures;
      made = skins;
    } else for (const url of pictures.values()) URL.revokeObjectURL(url);
  };
  const stop = effect(() => {
    const skins = own.skins.value;
    const shown = evaluator.result.value;
    const still = !state.previewing.value && !state.viewing.value;
    clearTimeout(wait);
    if (!skins || skins === made || !still || !shown?.settled || shown.shown.opened !== skins.skin.opened)
      return;
    const turn = ++run;
    wait = setTimeout(() => {
      make(skins, turn).catch((error: unknown) => messages.failed(error));
    }, QUIET);
  });
  return () => {
    stop();
    clearTimeout(wait);
    run++;
    clear();
  };
}
