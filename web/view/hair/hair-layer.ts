import {
  Box3,
  Group,
  type OrthographicCamera,
  type PerspectiveCamera,
  type Vector3,
  type WebGLRenderer,
} from 'three';
import { type Strands, strandCount } from '../../core/strands';
import type { ModelView } from '../model-view';
import { ViewSpace } from '../view-space';
import { CurveOverlay } from './curves';
import { GuideOverlay } from './guides';
import { HairView, type Head } from './hair-view';
import { drawsInSoftware, firstShare, nextShare, restShare } from './lod';
import type { Box, CurveHit, FieldSample, HairOptions, StyleCurve, SupportSurface } from './types';

/** So many strands say how much room hair takes in the picture. */
const FRAMING_STRANDS = 200;

/** Everything of hair in the picture: the strands, and the lines and surfaces one styles them with. */
export class HairLayer {
  readonly group = new Group();
  readonly #hair: HairView;
  readonly #curves = new CurveOverlay();
  readonly #guides = new GuideOverlay();
  #strands: Strands | null = null;
  #model: ModelView | undefined;
  #space = ViewSpace.identity;
  readonly #software: boolean;
  #fixedShare: number | null = null;
  #share = 1;
  #whole = false;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly test: boolean,
  ) {
    this.#hair = new HairView(!test);
    this.#software = drawsInSoftware(renderer.getContext());
    this.group.add(this.#hair.mesh, this.#guides.group, this.#curves.group);
  }

  /** Drawn space: the model's, or around the hair when it is alone. */
  get space(): ViewSpace {
    return this.#space;
  }

  get shown(): boolean {
    return this.#hair.shown;
  }

  /** Uniforms for the surfaces in its shadow, while there is any. */
  get shadowUniforms(): HairView['shadowUniforms'] | undefined {
    return this.#hair.shown ? this.#hair.shadowUniforms : undefined;
  }

  /** Where hair is, 3 numbers per place, drawn units: so few strands that a stray one hardly counts. */
  places(): number[] {
    const strands = this.#strands;
    if (!this.shown || !strands) return [];
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

  setModel(model: ModelView | undefined): void {
    this.#model = model;
    this.#settle();
    if (this.#strands) this.setHair(this.#strands);
  }

  setHair(strands: Strands | null): void {
    const had = this.#hair.total;
    this.#strands = strands;
    this.#settle();
    if (!strands || strandCount(strands) === 0) {
      this.#hair.clear();
      return;
    }
    this.#hair.set(strands, this.#space, this.#head(), this.renderer.capabilities.maxTextureSize);
    if (had !== this.#hair.total) this.#share = firstShare(this.#hair.total, this.#software);
  }

  setOptions(options: Partial<HairOptions>): void {
    this.#hair.setOptions(options);
  }

  /** A picture to keep has every strand, and no curves, field, volume or supporting surface. */
  setKept(kept: boolean): void {
    this.#whole = kept;
    this.#curves.group.visible = !kept;
    this.#guides.group.visible = !kept;
  }

  setShare(share: number | null): void {
    this.#fixedShare = share;
  }

  /** The last moving picture took `elapsed` ms. */
  paced(elapsed: number): void {
    if (this.shown) this.#share = nextShare(this.#share, elapsed, this.#hair.total);
  }

  setCurves(curves: readonly StyleCurve[]): void {
    this.#curves.set(curves, this.#space);
  }

  pickCurve(x: number, y: number, onScreen: (place: Vector3) => Vector3): CurveHit | null {
    return this.#curves.pick(x, y, (point) => onScreen(this.#space.toView(point)));
  }

  setField(field: FieldSample | null): void {
    this.#guides.setField(field, this.#space);
  }

  setConstraints(constraints: FieldSample | null): void {
    this.#guides.setConstraints(constraints, this.#space);
  }

  setVolume(box: Box | null): void {
    this.#guides.setVolume(box, this.#space);
  }

  setSupport(surface: SupportSurface | null): void {
    this.#guides.setSupport(surface, this.#space);
  }

  /** The head has changed its shape, or the graphics card has forgotten what it had. */
  lightChanged(): void {
    this.#hair.lightChanged();
  }

  setSize(width: number, height: number, pixelRatio: number): void {
    this.#curves.setSize(width, height, pixelRatio);
    this.#guides.setSize(width, height, pixelRatio);
  }

  /** @param frame  number of a picture at rest, from 1; 0: a moving one */
  prepare(camera: PerspectiveCamera | OrthographicCamera, frame: number): void {
    this.#hair.setShare(this.#fixedShare ?? this.#shareOf(frame));
    // In tests every picture is a finished one.
    this.#hair.prepare(this.renderer, camera, this.test ? Math.max(1, frame) : frame, this.#model?.geometry);
  }

  #shareOf(frame: number): number {
    if (this.#whole || this.test) return 1;
    return frame > 0 ? restShare(this.#share, this.#software) : this.#share;
  }

  dispose(): void {
    for (const part of [this.#hair, this.#curves, this.#guides]) part.dispose();
  }

  #head(): Head | undefined {
    const model = this.#model;
    return model && { geometry: model.geometry, places: model.places(), triangles: model.model.triangles };
  }

  #settle(): void {
    const before = this.#space;
    if (this.#model) this.#space = this.#model.space;
    else if (this.#strands) this.#space = spaceAround(this.#strands);
    else this.#space = ViewSpace.identity;
    if (this.#space === before) return;
    this.#curves.place(this.#space);
    this.#guides.place(this.#space);
  }
}

function spaceAround({ points, origin }: Strands): ViewSpace {
  const box = new Box3().setFromArray(points as unknown as number[]);
  if (box.isEmpty()) return ViewSpace.identity;
  const corners = [...box.min, ...box.max].map((x, i) => x + origin[i % 3]!);
  return ViewSpace.around({ positions: Float64Array.from(corners) });
}
