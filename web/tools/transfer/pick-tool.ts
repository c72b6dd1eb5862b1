import type { PointerSample } from '../../view/types';
import { clickSlop, distance, type Tool } from '../tool';

/** What can be pointed at on a model: its handles, by number. */
export interface PickHost {
  /** The handle under the pointer; `null` where there is none. */
  handleAt(sample: PointerSample): number | null;
  pick(handle: number): void;
}

/** A click on a handle picks it; everywhere else the camera has the pointer. */
export class PickTool implements Tool {
  #pressed: { readonly sample: PointerSample; readonly handle: number } | null = null;

  constructor(private readonly host: PickHost) {}

  down(sample: PointerSample): boolean {
    const handle = sample.button === 0 ? this.host.handleAt(sample) : null;
    if (handle === null) return false;
    this.#pressed = { sample, handle };
    return true;
  }

  move(): void {}

  up(sample: PointerSample): void {
    const pressed = this.#pressed;
    this.#pressed = null;
    if (pressed && distance(pressed.sample, sample) <= clickSlop(sample.pointerType))
      this.host.pick(pressed.handle);
  }

  hover(): void {}

  leave(): void {}

  cancel(): void {
    this.#pressed = null;
  }
}
