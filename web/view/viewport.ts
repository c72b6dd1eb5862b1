import { Plane, type Ray, Scene, Vector3, type WebGLRenderer } from 'three';
import { CameraRig } from './camera-rig';
import { DrawLoop } from './draw-loop';
import { Gizmo } from './gizmo';
import { keptPicture } from './kept-picture';
import type { LayerKind, Mounted } from './layer';
import { Layers } from './layers';
import { ModelView } from './model-view';
import { OrientationWidget, type ViewLabels } from './orientation-widget';
import { PALETTES, type Palette } from './palette';
import { Picker } from './picking';
import { PointerInput } from './pointer-input';
import { rendererFor } from './renderer';
import { Rest } from './rest';
import { Stage } from './stage';
import { SurfaceMaterials } from './surface-material';
import { thumbnail } from './thumbnail';
import type { ViewportPort } from './types';
import type {
  CameraState,
  DisplayOptions,
  GizmoEvents,
  GizmoState,
  Hit,
  PictureOptions,
  PointerHandler,
  RegionPaint,
  Vec3,
  ViewModel,
  ViewPreset,
} from './values';
import type { ViewSpace } from './view-space';
import { Wireframe } from './wireframe';

export interface ViewportOptions {
  /** Gives the size and takes the orientation widget; must be positioned. The canvas's parent by default. */
  readonly container?: HTMLElement;
  /** For tests: no antialiasing, one pixel a pixel, no motion. */
  readonly test?: boolean;
  /** Names of the views for screen readers. */
  readonly labels?: ViewLabels;
}

const DEFAULT_DISPLAY: DisplayOptions = {
  shading: 'clay',
  smooth: true,
  wireframe: false,
  grid: true,
  theme: 'dark',
};

/** The picture and the pointers over it. Draws only when something has changed. */
export class Viewport implements ViewportPort {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #rig = new CameraRig();
  readonly #stage: Stage;
  readonly #materials = new SurfaceMaterials();
  readonly #drawn = new Set<() => void>();
  readonly #gizmo: Gizmo;
  readonly #widget: OrientationWidget;
  readonly #input: PointerInput;
  readonly #resizes: ResizeObserver;
  readonly #stop = new AbortController();
  readonly #layers: Layers;
  readonly #rest: Rest;
  readonly #loop = new DrawLoop(
    (elapsed) => this.#advance(elapsed),
    () => this.#draw(),
  );

  #view: ModelView | undefined;
  #picker: Picker | undefined;
  #wireframe: Wireframe | undefined;
  #regions: readonly RegionPaint[] = [];
  #display = DEFAULT_DISPLAY;
  /** How often something has changed in the picture. */
  #stirs = 0;
  #idle: ReturnType<typeof setTimeout> | undefined;

  /** @throws LissomError  `webgl-missing`: no WebGL 2 */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly options: ViewportOptions = {},
  ) {
    this.#renderer = rendererFor(canvas, options.test);
    const container = options.container ?? canvas.parentElement ?? document.body;
    Object.assign(canvas.style, { display: 'block', width: '100%', height: '100%' });
    this.#stage = new Stage(this.#renderer, this.#scene, options.test);
    this.#layers = new Layers({
      renderer: this.#renderer,
      test: options.test ?? false,
      redraw: () => this.#redraw(),
      reshaped: () => this.#reshaped(),
      onScreen: (place) => this.#onScreen(place),
    });
    this.#scene.add(this.#layers.group);
    this.#gizmo = new Gizmo(this.#scene, this.#rig.camera, this.#space, () => this.#redraw());
    this.#widget = new OrientationWidget((preset) => this.setView(preset), options.labels);
    container.append(this.#widget.element);
    this.#rest = new Rest(this.#renderer, () => this.#loop.request());
    this.#input = new PointerInput(canvas, {
      rig: this.#rig,
      gizmo: this.#gizmo,
      pick: (x, y) => this.pick(x, y),
      changed: () => this.#redraw(),
    });
    this.#followMotionPreference();
    canvas.addEventListener('webglcontextrestored', () => this.#restore(), { signal: this.#stop.signal });
    this.#resizes = new ResizeObserver(() => this.#resize(container));
    this.#resizes.observe(container);
    this.#resize(container);
    this.setDisplay(DEFAULT_DISPLAY);
  }

  setModel(model: ViewModel | null, options: { readonly keepCamera?: boolean } = {}): void {
    const before = this.camera;
    this.#forgetModel();
    if (model && model.positions.length > 0) {
      const view = new ModelView(model);
      this.#view = view;
      this.#picker = new Picker(view);
      this.#materials.setSides(view);
      this.#scene.add(view.mesh);
    }
    this.#stage.setModel(this.#view && { space: this.#view.space, places: this.#view.places() });
    this.#layers.setModel(this.#view);
    this.setRegions([]);
    this.setHeat(null);
    this.setBrush(null);
    this.setGizmo(null);
    this.setDisplay(this.#display);
    if (options.keepCamera) this.camera = before;
    else {
      this.setView('home');
      this.#rig.jump();
    }
    const picker = this.#picker;
    if (picker && !this.options.test) this.#idle = setTimeout(() => picker.prepare(), 60);
  }

  setPositions(positions: Float64Array): void {
    this.#view?.setPositions(positions);
    this.#reshaped();
  }

  settlePositions(): void {
    this.#picker?.settle();
    this.#stage.shapeChanged();
    this.#layers.modelSettled();
    this.#redraw();
  }

  setRegions(regions: readonly RegionPaint[]): void {
    this.#regions = regions;
    this.#materials.setChannels(this.#view?.setRegions(regions) ?? [], this.#palette);
    this.#redraw();
  }

  setHeat(heat: { readonly values: Float32Array; readonly range: readonly [number, number] } | null): void {
    this.#materials.uniforms.heatShown.value = heat !== null;
    if (heat) this.#view?.setHeat(heat.values, heat.range);
    this.#redraw();
  }

  setDisplay(options: DisplayOptions): void {
    this.#display = options;
    const palette = this.#palette;
    this.#materials.uniforms.paintShown.value =
      options.shading === 'vertex-colours' && this.#view?.model.colors !== undefined;
    if (this.#view) {
      this.#view.mesh.material = this.#materials.of(options, this.#view.side);
      this.#materials.setChannels(this.#view.setRegions(this.#regions), palette);
    }
    for (const part of [this.#stage, this.#layers, this.#gizmo, this.#widget]) {
      part.setPalette(palette);
    }
    this.#stage.showGrid(options.grid);
    this.#showWireframe(options.wireframe, palette);
    this.#redraw();
  }

  setBrush(brush: { readonly hit: Hit; readonly radius: number; readonly erase: boolean } | null): void {
    if (this.#materials.setBrush(brush, this.#space)) this.#redraw();
  }

  setGizmo(gizmo: GizmoState | null, events?: GizmoEvents): void {
    this.#gizmo.set(gizmo, events, this.#space);
    this.#redraw();
  }

  mount<P>(kind: LayerKind<P>): Mounted<P> {
    return this.#layers.mount(kind);
  }

  pick(x: number, y: number): Hit | null {
    return this.#picker?.pick(this.#rig.ray(x, y)) ?? null;
  }

  verticesWithin(hit: Hit, radius: number): Uint32Array {
    return this.#picker?.verticesWithin(hit, radius) ?? new Uint32Array();
  }

  pointOnScreenPlane(x: number, y: number, through: Vec3): Vec3 {
    const facing = this.#rig.camera.getWorldDirection(new Vector3());
    const plane = new Plane().setFromNormalAndCoplanarPoint(facing, this.#space.toView(through));
    const ray: Ray = this.#rig.ray(x, y);
    const met = ray.intersectPlane(plane, new Vector3());
    return met ? this.#space.toModel(met) : through;
  }

  project(point: Vec3): { readonly x: number; readonly y: number; readonly behind: boolean } {
    const { x, y, z } = this.#onScreen(this.#space.toView(point));
    return { x, y, behind: z < 0 };
  }

  pixelSize(point: Vec3): number {
    return this.#rig.pixelSize(this.#space.toView(point)) / this.#space.scale;
  }

  fit(vertices?: Uint32Array): void {
    const places = this.#view?.places(vertices) ?? [];
    this.#rig.frame(vertices ? places : [...places, ...this.#layers.extent()]);
    this.#redraw();
  }

  setView(preset: ViewPreset): void {
    this.#rig.look(preset);
    this.fit();
  }

  get camera(): CameraState {
    return {
      position: this.#space.toModel(this.#rig.position),
      target: this.#space.toModel(this.#rig.target),
      orthographic: this.#rig.orthographic,
    };
  }

  set camera(state: CameraState) {
    this.#rig.setOrthographic(state.orthographic);
    this.#rig.standAt(this.#space.toView(state.position), this.#space.toView(state.target));
    this.#gizmo.setCamera(this.#rig.camera);
    this.#redraw();
  }

  setPointerHandler(handler: PointerHandler | null): void {
    if (this.#input.handler && this.#input.handler !== handler) this.#input.cancel();
    this.#input.handler = handler;
  }

  onDraw(listener: () => void): () => void {
    this.#drawn.add(listener);
    return () => this.#drawn.delete(listener);
  }

  get frameRate(): number {
    return this.#loop.rate;
  }

  screenshot(width: number, height: number, options: PictureOptions = {}): Promise<Blob> {
    return keptPicture(
      {
        renderer: this.#renderer,
        camera: () => this.#rig.camera,
        state: () => this.#stirs,
        drawAside: (draw) => this.#drawAside(width, height, draw),
        render: (frame) => this.#render(frame),
      },
      { width, height },
      { ...(this.options.test && { samples: 1 }), ...options },
    );
  }

  thumbnail(positions: Float64Array, width: number, height: number): Promise<Blob> {
    return thumbnail(this.#view, positions, {
      viewport: this,
      regions: this.#regions,
      canvas: this.#renderer.domElement,
      heatShown: this.#materials.uniforms.heatShown,
      rig: this.#rig,
      drawAside: (draw) => this.#drawAside(width, height, draw),
      render: () => this.#render(0),
    });
  }

  get size(): { readonly width: number; readonly height: number } {
    return this.#rig.size;
  }

  dispose(): void {
    this.#loop.dispose();
    this.#rest.dispose();
    this.#stop.abort();
    this.#resizes.disconnect();
    this.#input.dispose();
    this.#forgetModel();
    for (const part of [
      this.#gizmo,
      this.#widget,
      this.#layers,
      this.#stage,
      this.#materials,
      this.#renderer,
    ]) {
      part.dispose();
    }
  }

  get #space(): ViewSpace {
    return this.#layers.space;
  }

  get #palette(): Palette {
    return PALETTES[this.#display.theme];
  }

  get #pixelRatio(): number {
    return this.options.test ? 1 : Math.min(2, window.devicePixelRatio || 1);
  }

  #forgetModel(): void {
    clearTimeout(this.#idle);
    this.#showWireframe(false, this.#palette);
    this.#view?.mesh.removeFromParent();
    this.#view?.dispose();
    this.#view = undefined;
    this.#picker = undefined;
  }

  #showWireframe(shown: boolean, palette: Palette): void {
    if (shown && this.#view && !this.#wireframe) {
      this.#wireframe = new Wireframe(this.#view);
      this.#scene.add(this.#wireframe.lines);
    }
    if (!shown && this.#wireframe) {
      this.#wireframe.lines.removeFromParent();
      this.#wireframe.dispose();
      this.#wireframe = undefined;
    }
    this.#wireframe?.setPalette(palette);
  }

  #onScreen(place: Vector3): Vector3 {
    const { width, height } = this.#rig.size;
    const depth = place.clone().applyMatrix4(this.#rig.camera.matrixWorldInverse).z;
    const { x, y } = place.clone().project(this.#rig.camera);
    return new Vector3(((x + 1) / 2) * width, ((1 - y) / 2) * height, -depth);
  }

  #followMotionPreference(): void {
    const still = window.matchMedia('(prefers-reduced-motion: reduce)');
    const follow = (): void => {
      this.#rig.soft = !still.matches && !this.options.test;
    };
    still.addEventListener('change', follow, { signal: this.#stop.signal });
    follow();
  }

  #resize(container: HTMLElement): void {
    const { clientWidth, clientHeight } = container;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#size(clientWidth, clientHeight, this.#pixelRatio);
    this.#rest.stirred();
    // At once, for a resized canvas is empty until it is drawn.
    this.#draw();
  }

  #size(width: number, height: number, pixelRatio: number): void {
    this.#renderer.setPixelRatio(pixelRatio);
    this.#renderer.setSize(width, height, false);
    this.#materials.uniforms.pixelRatio.value = pixelRatio;
    this.#materials.uniforms.pixelsTall.value = pixelRatio * height;
    this.#layers.resize(width, height, pixelRatio);
    this.#rig.resize(width, height);
  }

  /**
   * Draws on a canvas of another size what is no tool, and puts everything back: within the same task the
   * drawing buffer holds the picture, and nobody sees the detour.
   */
  #drawAside(width: number, height: number, draw: () => void): void {
    const { width: w, height: h } = this.#rig.size;
    const { brushRadius } = this.#materials.uniforms;
    const brush = brushRadius.value;
    brushRadius.value = 0;
    this.#gizmo.visible = false;
    this.#layers.setKept(true);
    this.#size(width, height, 1);
    this.#stage.prepare(this.#view?.geometry);
    draw();
    brushRadius.value = brush;
    this.#gizmo.visible = true;
    this.#layers.setKept(false);
    this.#size(w, h, this.#pixelRatio);
    if (!this.#rest.drawAgain()) this.#draw();
  }

  #restore(): void {
    this.#stage.restore();
    this.#layers.restore();
    this.#redraw();
  }

  #reshaped(): void {
    if (!this.options.test) this.#stage.shapeChanged(); // software rendering cannot afford it at every step
    this.#redraw();
  }

  #redraw(): void {
    this.#stirs++;
    this.#rest.stirred();
    this.#loop.request();
  }

  #advance(elapsed: number): boolean {
    const moving = this.#rig.advance(elapsed);
    if (moving) {
      this.#stirs++;
      this.#rest.stirred();
      this.#layers.paced(elapsed);
    }
    return moving;
  }

  #draw(): void {
    if (this.#renderer.getContext().isContextLost()) return;
    this.#stage.prepare(this.#view?.geometry);
    const { camera } = this.#rig;
    this.#gizmo.setCamera(camera);
    if (this.#rest.due) this.#rest.draw(camera, (frame) => this.#render(frame));
    else {
      this.#render(0);
      if (this.#layers.refine && !this.options.test) this.#rest.wait();
    }
    this.#widget.update(camera, this.#space);
    for (const listener of this.#drawn) listener();
  }

  /** @param frame  number of a picture at rest, from 1; 0: a moving one */
  #render(frame: number): void {
    this.#wireframe?.prepare(this.#rig.pixelSize(this.#rig.target));
    this.#layers.prepare(this.#rig.camera, frame);
    this.#materials.setShades(this.#layers.shades);
    this.#stage.showGround(!this.#layers.bare);
    this.#renderer.render(this.#scene, this.#rig.camera);
  }
}
