import type { PointerSample } from '../../view/types';
import type { Tool } from '../tool';
import type { HandleDrag } from './handle-drag';
import type { DeformHost } from './host';
import { grab, placePoint, SelectTool } from './select-tool';

/** A click on the surface places a point handle, which may be dragged on; on a handle it works like select. */
export class PointTool implements Tool {
  readonly #select: SelectTool;
  #drag: HandleDrag | SelectTool | null = null;

  constructor(private readonly host: DeformHost) {
    this.#select = new SelectTool(host);
  }

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return false;
    if (grab(this.host, scene, sample)) {
      this.#drag = this.#select;
      return this.#select.down(sample);
    }
    this.#drag = placePoint(this.host, scene, sample, sample.hit.vertex);
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    this.#drag?.move(samples);
  }

  up(sample: PointerSample): void {
    const drag = this.#drag;
    this.#drag = null;
    if (drag instanceof SelectTool) drag.up(sample);
    else drag?.finish(sample);
  }

  hover(): void {}

  leave(): void {}

  cancel(): void {
    this.#drag?.cancel();
    this.#drag = null;
  }
}
