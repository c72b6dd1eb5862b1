// Paints a part of the skin: the selected one, or a new one while none is.

import type { PointerSample } from '../../view/types';
import { PaintTool } from '../paint-tool';
import { clickSlop, distance, type Tool } from '../tool';
import { partAt, partVertices } from './edits';
import type { BlendHost, BlendScene } from './host';

export const PART = 'part';

export const paintPart = (host: BlendHost): Tool =>
  new PaintTool<BlendScene>(host, {
    kind: PART,
    scene: () => host.scene(),
    canvas: ({ step, count, selected }) => {
      const part = selected === null ? undefined : step.parts[selected];
      return {
        base: part ? partVertices(part, count) : new Uint32Array(),
        commit: (verb, vertices) => host.commit(verb, part ? selected : null, vertices),
      };
    },
  });

/** A click picks the part under the pointer, or none; a drag turns the view. */
export class PickPart implements Tool {
  #pressed: PointerSample | null = null;

  constructor(private readonly host: BlendHost) {}

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return false;
    // The camera has the pointer where there is nothing to pick.
    if (partAt(scene.step, sample.hit.vertex) < 0) return false;
    this.#pressed = sample;
    return true;
  }

  move(): void {}

  up(sample: PointerSample): void {
    const pressed = this.#pressed;
    this.#pressed = null;
    const scene = this.host.scene();
    if (!pressed?.hit || !scene || distance(pressed, sample) > clickSlop(sample.pointerType)) return;
    this.host.pick(partAt(scene.step, pressed.hit.vertex));
  }

  hover(): void {}

  leave(): void {}

  cancel(): void {
    this.#pressed = null;
  }
}

/** A click says where a tape is laid around the skin. */
export class GirthTool implements Tool {
  #pressed: PointerSample | null = null;

  constructor(private readonly host: BlendHost) {}

  down(sample: PointerSample): boolean {
    if (!this.host.scene() || sample.button !== 0 || !sample.hit) return false;
    this.#pressed = sample;
    return true;
  }

  move(): void {}

  up(sample: PointerSample): void {
    const pressed = this.#pressed;
    this.#pressed = null;
    if (pressed?.hit && distance(pressed, sample) <= clickSlop(sample.pointerType))
      this.host.measure(pressed.hit.vertex);
  }

  hover(): void {}

  leave(): void {}

  cancel(): void {
    this.#pressed = null;
  }
}
