import type { PointerSample } from '../view/types';
import { clickSlop, distance, type Tool } from './tool';

/** What can be pointed at on a model: handles or parts by number, or its vertices. */
export interface PickHost {
  /** What is under the pointer; `null` where there is nothing. */
  at(sample: PointerSample): number | null;
  pick(what: number, sample: PointerSample): void;
}

/** A click on something picks it; everywhere else the camera has the pointer. */
export class PickTool implements Tool {
  #pressed: { readonly sample: PointerSample; readonly what: number } | null = null;

  constructor(private readonly host: PickHost) {}

  down(sample: PointerSample): boolean {
    const what = sample.button === 0 ? this.host.at(sample) : null;
    if (what === null) return false;
    this.#pressed = { sample, what };
    return true;
  }

  move(): void {}

  up(sample: PointerSample): void {
    const pressed = this.#pressed;
    this.#pressed = null;
    if (pressed && distance(pressed.sample, sample) <= clickSlop(sample.pointerType))
      this.host.pick(pressed.what, pressed.sample);
  }

  hover(_: PointerSample): void {}

  leave(): void {}

  cancel(): void {
    this.#pressed = null;
  }
}
