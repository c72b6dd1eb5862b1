import type { PointerSample } from '../../view/types';
import { SurfaceStroke } from '../stroke/stroke';
import { type Ray, rayAt } from '../stroke/support';
import type { Tool } from '../tool';
import type { CurvesHost } from './host';

/** Samples nearer to the last one than this add nothing, in CSS pixels. */
const STILL = 1.5;

/** Draws curves: a stroke that begins on the model becomes one when it ends. Elsewhere the camera turns. */
export class SketchTool implements Tool {
  #stroke: SurfaceStroke | null = null;
  #samples: { readonly x: number; readonly y: number }[] = [];
  #rays: Ray[] = [];

  constructor(private readonly host: CurvesHost) {}

  down(sample: PointerSample): boolean {
    if (!this.host.scene() || sample.button !== 0 || !sample.hit) return false;
    this.#stroke = new SurfaceStroke(this.host.view);
    this.#samples = [];
    this.#rays = [];
    this.#extend([sample]);
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    if (!this.#stroke) return;
    this.#extend(samples);
    this.host.foresee({ samples: [...this.#samples], rays: [...this.#rays] });
  }

  up(sample: PointerSample): void {
    if (!this.#stroke) return;
    this.#extend([sample]);
    const stroke = { samples: this.#samples, rays: this.#rays };
    this.#end();
    if (stroke.samples.length < 2) {
      this.host.say('too-short');
      return;
    }
    this.host.draw(stroke).catch((error: unknown) => this.host.failed(error));
  }

  hover(): void {}

  leave(): void {}

  cancel(): void {
    this.#end();
    this.host.cancel();
  }

  #end(): void {
    this.#stroke = null;
    this.host.showStroke(null);
  }

  #extend(samples: readonly PointerSample[]): void {
    this.#stroke!.extend(samples);
    for (const { x, y } of samples) {
      const last = this.#samples.at(-1);
      if (last && Math.hypot(last.x - x, last.y - y) < STILL) continue;
      this.#samples.push({ x, y });
      this.#rays.push(rayAt(this.host.view, x, y));
    }
    this.host.showStroke([...this.#stroke!.line]);
  }
}
