import { Color, type Group } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import { ViewSpace } from '../view-space';
import { NO_SEGMENTS, SegmentLines, type Segments } from './segments';
import type { Box, BoxPort } from './types';

/** CSS pixels. */
const EDGE = 1.25;
const COLOUR = '#98a2ae';

/** The edges of a box along the model's axes. */
class BoxOverlay implements Layer, BoxPort {
  readonly aid = true;
  readonly #edges = new SegmentLines({ hidden: 0.4, order: 12 });
  #box: Box | null = null;
  #space = ViewSpace.identity;

  constructor(private readonly context: LayerContext) {}

  get group(): Group {
    return this.#edges.group;
  }

  place(space: ViewSpace): void {
    this.#space = space;
    this.#draw();
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.#edges.resize(width, height, pixelRatio);
  }

  setVolume(box: Box | null): void {
    this.#box = box;
    this.#draw();
    this.context.redraw();
  }

  dispose(): void {
    this.#edges.dispose();
  }

  #draw(): void {
    this.#edges.set(this.#box ? edges(this.#box, this.#space) : NO_SEGMENTS);
  }
}

export const BOX: LayerKind<BoxPort> = {
  id: 'box',
  make: (context) => new BoxOverlay(context),
};

function edges({ low, high }: Box, space: ViewSpace): Segments {
  const corner = (bits: number): number[] => [
    ...space.toView([(bits & 1 ? high : low)[0], (bits & 2 ? high : low)[1], (bits & 4 ? high : low)[2]]),
  ];
  const pairs = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((bits) =>
    [1, 2, 4].filter((bit) => (bits & bit) === 0).map((bit) => [...corner(bits), ...corner(bits | bit)]),
  );
  const colour = new Color(COLOUR).convertLinearToSRGB().toArray();
  return {
    ends: Float32Array.from(pairs.flat()),
    looks: Float32Array.from(pairs.flatMap(() => [...colour, EDGE])),
  };
}
