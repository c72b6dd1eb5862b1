import { Color, type Group } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import type { ModelView } from '../model-view';
import type { Palette } from '../palette';
import { ViewSpace } from '../view-space';
import { SegmentLines } from './segments';
import type { LoopLine, LoopsPort } from './types';

/** CSS pixels. */
const WIDTH = 2.5;
const STRONG_WIDTH = 4.5;
const WHITE = '#ffffff';

/** Closed lines on the model; they show faintly through what lies in front of them. */
class LoopLines implements Layer, LoopsPort {
  readonly aid = true;
  readonly #lines = new SegmentLines({ hidden: 0.25, order: 14 });
  #shown: readonly LoopLine[] = [];
  #space = ViewSpace.identity;
  #model: ModelView | undefined;
  #palette: Palette | undefined;

  constructor(private readonly context: LayerContext) {}

  get group(): Group {
    return this.#lines.group;
  }

  place(space: ViewSpace, model: ModelView | undefined): void {
    if (model !== this.#model) this.#shown = [];
    this.#space = space;
    this.#model = model;
    this.#draw();
  }

  setLoops(loops: readonly LoopLine[]): void {
    this.#shown = loops;
    this.#draw();
    this.context.redraw();
  }

  setPalette(palette: Palette): void {
    this.#palette = palette;
    this.#draw();
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.#lines.resize(width, height, pixelRatio);
  }

  dispose(): void {
    this.#lines.dispose();
  }

  #draw(): void {
    const count = this.#shown.reduce((sum, { points }) => sum + points.length / 3, 0);
    const ends = new Float32Array(6 * count);
    const looks = new Float32Array(4 * count);
    let at = 0;
    for (const { points, tint, strong } of this.#shown) {
      const places = new Float32Array(points.length);
      this.#space.place(points, places);
      const colour = new Color((tint && this.#palette?.tints[tint]) ?? WHITE).convertLinearToSRGB().toArray();
      for (let i = 0; i < places.length; i += 3, at++) {
        const next = (i + 3) % places.length;
        ends.set([...places.subarray(i, i + 3), ...places.subarray(next, next + 3)], 6 * at);
        looks.set([...colour, strong ? STRONG_WIDTH : WIDTH], 4 * at);
      }
    }
    this.#lines.set({ ends, looks });
  }
}

export const LOOPS: LayerKind<LoopsPort> = {
  id: 'loops',
  make: (context) => new LoopLines(context),
};
