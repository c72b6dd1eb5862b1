import { Color, Group } from 'three';
import { heatColour } from '../heat';
import type { Layer, LayerContext, LayerKind } from '../layer';
import { ViewSpace } from '../view-space';
import { NO_SEGMENTS, SegmentLines, type Segments } from './segments';
import type { FieldPort, FieldSample } from './types';

/** CSS pixels. */
const ARROW = 3;
const CONSTRAINT_COLOUR = new Color('#e3b341').convertLinearToSRGB();

/** Long arrows warm, short ones cool. */
const byLength = (share: number): Color => new Color(...heatColour(share)).convertLinearToSRGB();

/** Arrows of a field, and of what it was asked for. */
class FieldOverlay implements Layer, FieldPort {
  readonly group = new Group();
  readonly aid = true;
  readonly #field = new Arrows(10, byLength);
  readonly #constraints = new Arrows(11, () => CONSTRAINT_COLOUR);

  constructor(private readonly context: LayerContext) {
    this.group.add(this.#field.lines.group, this.#constraints.lines.group);
  }

  place(space: ViewSpace): void {
    this.#field.place(space);
    this.#constraints.place(space);
  }

  resize(width: number, height: number, pixelRatio: number): void {
    for (const { lines } of [this.#field, this.#constraints]) lines.resize(width, height, pixelRatio);
  }

  setField(field: FieldSample | null): void {
    this.#field.set(field);
    this.context.redraw();
  }

  setConstraints(constraints: FieldSample | null): void {
    this.#constraints.set(constraints);
    this.context.redraw();
  }

  dispose(): void {
    this.#field.lines.dispose();
    this.#constraints.lines.dispose();
  }
}

class Arrows {
  readonly lines: SegmentLines;
  #sample: FieldSample | null = null;
  #space = ViewSpace.identity;

  /** @param colourOf  by length, as a share of the longest */
  constructor(
    order: number,
    private readonly colourOf: (share: number) => Color,
  ) {
    this.lines = new SegmentLines({ hidden: 0, order, arrows: true });
  }

  set(sample: FieldSample | null): void {
    this.#sample = sample;
    this.lines.set(sample ? arrows(sample, this.#space, this.colourOf) : NO_SEGMENTS);
  }

  place(space: ViewSpace): void {
    this.#space = space;
    this.set(this.#sample);
  }
}

export const FIELD: LayerKind<FieldPort> = {
  id: 'field',
  make: (context) => new FieldOverlay(context),
};

function arrows(
  { places, vectors }: FieldSample,
  space: ViewSpace,
  colourOf: (share: number) => Color,
): Segments {
  const count = Math.floor(Math.min(places.length, vectors.length) / 3);
  const lengths = Float64Array.from({ length: count }, (_, i) =>
    Math.hypot(vectors[3 * i]!, vectors[3 * i + 1]!, vectors[3 * i + 2]!),
  );
  const longest = lengths.reduce((most, length) => Math.max(most, length), 0) || 1;
  const ends = new Float32Array(6 * count);
  const looks = new Float32Array(4 * count);
  for (let i = 0; i < count; i++) {
    const [x, y, z] = [places[3 * i]!, places[3 * i + 1]!, places[3 * i + 2]!];
    const tip = [x + vectors[3 * i]!, y + vectors[3 * i + 1]!, z + vectors[3 * i + 2]!] as const;
    ends.set([...space.toView([x, y, z]), ...space.toView(tip)], 6 * i);
    looks.set([...colourOf(lengths[i]! / longest), ARROW], 4 * i);
  }
  return { ends, looks };
}
