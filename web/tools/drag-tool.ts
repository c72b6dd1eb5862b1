import type { PointerSample } from '../view/types';
import type { Tool } from './tool';

/** One grab, from press to release. */
export interface Drag {
  move(samples: readonly PointerSample[]): void;
  finish(sample: PointerSample): void;
  cancel(): void;
}

/** A tool whose press takes hold of something; elsewhere the camera turns. */
export abstract class DragTool implements Tool {
  #drag: Drag | null = null;

  /** @returns `null` where there is nothing to take hold of */
  protected abstract take(sample: PointerSample): Drag | null;

  down(sample: PointerSample): boolean {
    const drag = this.take(sample);
    if (!drag) return false;
    this.#drag = drag;
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    this.#drag?.move(samples);
  }

  up(sample: PointerSample): void {
    const drag = this.#drag;
    this.#drag = null;
    drag?.finish(sample);
  }

  hover(_: PointerSample): void {}

  leave(): void {}

  cancel(): void {
    this.#drag?.cancel();
    this.#drag = null;
  }
}
