import { Color, type Group } from 'three';
import { SegmentLines } from './hair/segments';
import type { Palette } from './palette';
import type { LoopLine } from './types';
import type { ViewSpace } from './view-space';

/** CSS pixels. */
const WIDTH = 2.5;
const STRONG_WIDTH = 4.5;
const OPEN = '#ffffff';

/** Closed lines on the model; they show faintly through what lies in front of them. */
export class LoopLines {
  readonly #lines = new SegmentLines({ hidden: 0.25, order: 14 });
  #shown: readonly LoopLine[] = [];
  #space: ViewSpace | undefined;
  #palette: Palette | undefined;

  get group(): Group {
    return this.#lines.group;
  }

  set(loops: readonly LoopLine[], space: ViewSpace): void {
    this.#shown = loops;
    this.#space = space;
    this.#draw();
  }

  setPalette(palette: Palette): void {
    this.#palette = palette;
    this.#draw();
  }

  setSize(width: number, height: number, pixelRatio: number): void {
    this.#lines.setSize(width, height);
    this.#lines.setPixelRatio(pixelRatio);
  }

  dispose(): void {
    this.#lines.dispose();
  }

  #draw(): void {
    const space = this.#space;
    if (!space) return;
    const count = this.#shown.reduce((sum, { points }) => sum + points.length / 3, 0);
    const ends = new Float32Array(6 * count);
    const looks = new Float32Array(4 * count);
    let at = 0;
    for (const { points, kind, strong } of this.#shown) {
      const places = new Float32Array(points.length);
      space.place(points, places);
      const name = kind === 'open' ? OPEN : (this.#palette?.regions[kind] ?? OPEN);
      const colour = new Color(name).convertLinearToSRGB().toArray();
      for (let i = 0; i < places.length; i += 3, at++) {
        const next = (i + 3) % places.length;
        ends.set([...places.subarray(i, i + 3), ...places.subarray(next, next + 3)], 6 * at);
        looks.set([...colour, strong ? STRONG_WIDTH : WIDTH], 4 * at);
      }
    }
    this.#lines.set({ ends, looks });
  }
}
