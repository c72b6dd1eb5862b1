import { Box3, Group, type OrthographicCamera, type PerspectiveCamera } from 'three';
import { type Strands, strandCount } from '../../core/strands';
import type { Layer, LayerContext, LayerKind } from '../layer';
import type { ModelView } from '../model-view';
import { drawsInSoftware } from '../software';
import type { SurfaceShade } from '../surface-shade';
import { ViewSpace } from '../view-space';
import type { Head } from './baked-light';
import { HairView } from './hair-view';
import { firstShare, nextShare, restShare } from './lod';
import type { HairOptions, HairPort } from './types';

/** So many strands say how much room hair takes in the picture. */
const FRAMING_STRANDS = 200;

/** The strands of one head in the picture, and the light they take from it. */
class HairLayer implements Layer, HairPort {
  readonly group = new Group();
  readonly #hair: HairView;
  #strands: Strands | null = null;
  #model: ModelView | undefined;
  #space = ViewSpace.identity;
  /** Around the strands, where they are drawn alone. */
  #around: ViewSpace | undefined;
  readonly #software: boolean;
  #fixedShare: number | null = null;
  #share = 1;
  #whole = false;

  constructor(private readonly context: LayerContext) {
    this.#hair = new HairView(!context.test);
    this.#software = drawsInSoftware(context.renderer.getContext());
    this.group.add(this.#hair.mesh);
  }

  get shade(): SurfaceShade | undefined {
    return this.#hair.shown ? this.#hair.shade : undefined;
  }

  get refines(): boolean {
    return this.#hair.shown;
  }

  ownSpace(): ViewSpace | undefined {
    if (this.#strands) this.#around ??= spaceAround(this.#strands);
    return this.#around;
  }

  /** So few strands that a stray one hardly counts. */
  extent(): number[] {
    const strands = this.#strands;
    if (!this.#hair.shown || !strands) return [];
    const { offsets, points, origin } = strands;
    const every = Math.max(1, Math.floor(strandCount(strands) / FRAMING_STRANDS));
    const places: number[] = [];
    for (let s = 0; s < strandCount(strands); s += every)
      for (let p = offsets[s]!; p < offsets[s + 1]!; p++) {
        const [x, y, z] = [points[3 * p]!, points[3 * p + 1]!, points[3 * p + 2]!];
        places.push(...this.#space.toView([x + origin[0], y + origin[1], z + origin[2]]));
      }
    return places;
  }

  place(space: ViewSpace, model: ModelView | undefined): void {
    this.#space = space;
    this.#model = model;
    if (this.#strands) this.#show();
  }

  setHair(strands: Strands | null): void {
    const { context } = this;
    const before = this.#space;
    this.#strands = strands;
    this.#around = undefined;
    context.settle();
    // Placed anew it shows them already.
    if (!strands || this.#space === before) this.#show();
    context.redraw();
  }

  setHairOptions(options: Partial<HairOptions>): void {
    this.#hair.setOptions(options);
    this.context.redraw();
  }

  setStrandShare(share: number | null): void {
    this.#fixedShare = share;
    this.context.redraw();
  }

  /** A picture to keep has every strand. */
  setKept(kept: boolean): void {
    this.#whole = kept;
  }

  paced(elapsed: number): void {
    if (this.#hair.shown) this.#share = nextShare(this.#share, elapsed, this.#hair.total);
  }

  modelSettled(): void {
    this.#hair.lightChanged();
  }

  restore(): void {
    this.#hair.lightChanged();
  }

  prepare(camera: PerspectiveCamera | OrthographicCamera, frame: number): void {
    const { renderer, test } = this.context;
    this.#hair.setShare(this.#fixedShare ?? this.#shareOf(frame));
    this.#hair.prepare(renderer, camera, test ? Math.max(1, frame) : frame, this.#model?.geometry);
  }

  dispose(): void {
    this.#hair.dispose();
  }

  #show(): void {
    const strands = this.#strands;
    if (!strands || strandCount(strands) === 0) {
      this.#hair.clear();
      return;
    }
    const had = this.#hair.total;
    this.#hair.set(strands, this.#space, this.#head(), this.context.renderer.capabilities.maxTextureSize);
    if (had !== this.#hair.total) this.#share = firstShare(this.#hair.total, this.#software);
  }

  #shareOf(frame: number): number {
    if (this.#whole || this.context.test) return 1;
    return frame > 0 ? restShare(this.#share, this.#software) : this.#share;
  }

  #head(): Head | undefined {
    const model = this.#model;
    return model && { geometry: model.geometry, places: model.places(), triangles: model.model.triangles };
  }
}

export const HAIR: LayerKind<HairPort> = {
  id: 'hair',
  make: (context) => new HairLayer(context),
};

function spaceAround({ points, origin }: Strands): ViewSpace {
  const box = new Box3().setFromArray(points as unknown as number[]);
  if (box.isEmpty()) return ViewSpace.identity;
  const corners = [...box.min, ...box.max].map((x, i) => x + origin[i % 3]!);
  return ViewSpace.around({ positions: Float64Array.from(corners) });
}
