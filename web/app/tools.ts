// The pointer goes to the tool that is chosen; one handler for a viewport, whichever tool it is.

import type { Tool } from '../tools/tool';
import type { PointerHandler, PointerSample, ViewportPort } from '../view/types';
import type { SettingsService } from './api';

/** Gives the pointer of a viewport to the tool that is chosen, and keeps a gesture with the tool that began it. */
export class PointerSwitch implements PointerHandler {
  /** The tool that has the gesture under way. */
  #held: Tool | null = null;

  /** @param chosen  undefined where the chosen tool has nothing to do here: then only the camera moves */
  constructor(
    private readonly view: Pick<ViewportPort, 'setBrush'>,
    private readonly chosen: () => Tool | undefined,
    private readonly settings: SettingsService,
  ) {}

  /** Whether a gesture is under way. */
  get busy(): boolean {
    return this.#held !== null;
  }

  down(sample: PointerSample): boolean {
    if (sample.pointerType === 'touch' && this.settings.values.peek().penOnly) return false;
    const tool = this.chosen();
    if (!tool?.down(sample)) return false;
    this.#held = tool;
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    this.#held?.move(samples);
  }

  up(sample: PointerSample): void {
    const tool = this.#held;
    this.#held = null;
    tool?.up(sample);
  }

  hover(sample: PointerSample): void {
    this.chosen()?.hover(sample);
  }

  leave(): void {
    this.chosen()?.leave();
    this.view.setBrush(null);
  }

  /** @returns whether there was a gesture to end */
  cancel(): boolean {
    const { busy } = this;
    this.#held?.cancel();
    this.#held = null;
    return busy;
  }
}
