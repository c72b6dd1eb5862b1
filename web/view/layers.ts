import { Group, type OrthographicCamera, type PerspectiveCamera } from 'three';
import type { Layer, LayerContext, LayerKind, Mounted } from './layer';
import type { ModelView } from './model-view';
import type { Palette } from './palette';
import type { SurfaceShade } from './surface-shade';
import { ViewSpace } from './view-space';

/** The layers in a picture: what one of them has to know, all are told, those that come later too. */
export class Layers {
  readonly group = new Group();
  readonly #aids = new Group();
  readonly #mounted = new Set<Layer>();
  readonly #context: LayerContext;
  #model: ModelView | undefined;
  #space = ViewSpace.identity;
  #palette: Palette | undefined;
  #size: readonly [width: number, height: number, pixelRatio: number] | undefined;

  constructor(context: Omit<LayerContext, 'settle'>) {
    this.#context = { ...context, settle: () => this.#settle() };
    this.group.add(this.#aids);
  }

  /** Drawn space: the model's, or that of what is drawn without one. */
  get space(): ViewSpace {
    return this.#space;
  }

  get shades(): SurfaceShade[] {
    return [...this.#mounted].flatMap(({ shade }) => shade ?? []);
  }

  get bare(): boolean {
    return [...this.#mounted].some(({ bare }) => bare);
  }

  get refine(): boolean {
    return [...this.#mounted].some(({ refines }) => refines);
  }

  mount<P>(kind: LayerKind<P>): Mounted<P> {
    const layer = kind.make(this.#context);
    if (this.#palette) layer.setPalette?.(this.#palette);
    if (this.#size) layer.resize?.(...this.#size);
    layer.place(this.#space, this.#model);
    (layer.aid ? this.#aids : this.group).add(layer.group);
    this.#mounted.add(layer);
    this.#settle();
    this.#context.redraw();
    return { port: layer, unmount: () => this.#unmount(layer) };
  }

  setModel(model: ModelView | undefined): void {
    this.#model = model;
    this.#space = this.#wanted();
    for (const layer of this.#mounted) layer.place(this.#space, model);
  }

  setPalette(palette: Palette): void {
    this.#palette = palette;
    for (const layer of this.#mounted) layer.setPalette?.(palette);
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.#size = [width, height, pixelRatio];
    for (const layer of this.#mounted) layer.resize?.(width, height, pixelRatio);
  }

  /** What should be in sight beside the model, 3 numbers per place, drawn units. */
  extent(): number[] {
    return [...this.#mounted].flatMap((layer) => Array.from(layer.extent?.() ?? []));
  }

  modelSettled(): void {
    for (const layer of this.#mounted) layer.modelSettled?.();
  }

  restore(): void {
    for (const layer of this.#mounted) layer.restore?.();
  }

  setKept(kept: boolean): void {
    this.#aids.visible = !kept;
    for (const layer of this.#mounted) layer.setKept?.(kept);
  }

  paced(elapsed: number): void {
    for (const layer of this.#mounted) layer.paced?.(elapsed);
  }

  prepare(camera: PerspectiveCamera | OrthographicCamera, frame: number): void {
    for (const layer of this.#mounted) layer.prepare?.(camera, frame);
  }

  dispose(): void {
    for (const layer of [...this.#mounted]) this.#remove(layer);
  }

  #unmount(layer: Layer): void {
    if (!this.#remove(layer)) return;
    this.#settle();
    this.#context.redraw();
  }

  #remove(layer: Layer): boolean {
    if (!this.#mounted.delete(layer)) return false;
    layer.group.removeFromParent();
    layer.dispose();
    return true;
  }

  #settle(): void {
    const space = this.#wanted();
    if (space === this.#space) return;
    this.#space = space;
    for (const layer of this.#mounted) layer.place(space, this.#model);
  }

  #wanted(): ViewSpace {
    if (this.#model) return this.#model.space;
    for (const layer of this.#mounted) {
      const own = layer.ownSpace?.();
      if (own) return own;
    }
    return ViewSpace.identity;
  }
}
