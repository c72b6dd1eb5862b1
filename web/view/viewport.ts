import {
  ACESFilmicToneMapping,
  BackSide,
  DoubleSide,
  FrontSide,
  PCFShadowMap,
  Plane,
  type Ray,
  Scene,
  type Side,
  Vector3,
  WebGLRenderer,
} from 'three';
import { LissomError } from '../core/errors';
import type { Strands } from '../core/strands';
import { CameraRig } from './camera-rig';
import { DrawLoop } from './draw-loop';
import { Gizmo } from './gizmo';
import { HairLayer } from './hair/hair-layer';
import { Rest } from './hair/rest';
import { StillPicture } from './hair/still';
import type { Box, CurveHit, FieldSample, HairOptions, StyleCurve, SupportSurface } from './hair/types';
import { LoopLines } from './loop-lines';
import { Markers } from './markers';
import { ModelView } from './model-view';
import { OrientationWidget, type ViewLabels } from './orientation-widget';
import { PALETTES, type Palette } from './palette';
import { Picker } from './picking';
import { type NavigationOptions, PointerInput } from './pointer-input';
import { Stage } from './stage';
import { SurfaceMaterials } from './surface-material';
import type {
  CameraState,
  DisplayOptions,
  GizmoEvents,
  GizmoState,
  Hit,
  LoopLine,
  PictureOptions,
  PointerHandler,
  PointMarker,
  RegionPaint,
  Vec3,
  ViewModel,
  ViewPreset,
  ViewportPort,
} from './types';
import { ViewSpace } from './view-space';
import { Wireframe } from './wireframe';

export interface ViewportOptions {
  /** Gives the size and takes the orientation widget; must be positioned. The canvas's parent by default. */
  readonly container?: HTMLElement;
  /** For tests: no antialiasing, one pixel a pixel, no motion. */
  readonly test?: boolean;
  /** Names of the views for screen readers. */
  readonly labels?: ViewLabels;
}

/** Fingers and pens are less exact than this many CSS pixels. */
const MARKER_REACH = 14;
/** Over clay in either theme. */
const BRUSH_ADDS = '#ffffff';
const BRUSH_ERASES = '#ff7a72';
/** Pictures that make one to keep. */
const SCREENSHOT_SAMPLES = 32;
/** Fewer show strands as dots. */
const FEWEST = 4;
/** A page that is not looked at draws no frames, but goes on after so many ms. */
const UNSEEN = 200;
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
  readonly #markers = new Markers();
  readonly #loops = new LoopLines();
  readonly #drawn = new Set<() => void>();
  readonly #gizmo: Gizmo;
  readonly #widget: OrientationWidget;
  readonly #input: PointerInput;
  readonly #resizes: ResizeObserver;
  readonly #stop = new AbortController();
  readonly #hair: HairLayer;
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
    private readonly canvas: HTMLCanvasElement,
    private readonly options: ViewportOptions = {},
  ) {
    this.#renderer = rendererFor(canvas, options);
    const container = options.container ?? canvas.parentElement ?? document.body;
    Object.assign(canvas.style, { display: 'block', width: '100%', height: '100%' });
    this.#stage = new Stage(this.#renderer, this.#scene, options.test);
    this.#gizmo = new Gizmo(this.#scene, this.#rig.camera, ViewSpace.identity, () => this.#redraw());
    this.#widget = new OrientationWidget((preset) => this.setView(preset), options.labels);
    container.append(this.#widget.element);
    this.#hair = new HairLayer(this.#renderer, options.test ?? false);
    this.#rest = new Rest(this.#renderer, () => this.#loop.request());
    this.#scene.add(this.#markers.group, this.#loops.group, this.#hair.group);
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
      this.#materials.uniforms.inwards.value = view.inwards;
      this.#scene.add(view.mesh);
    }
    this.#stage.setModel(this.#view && { space: this.#view.space, places: this.#view.places() });
    this.#hair.setModel(this.#view);
    this.setRegions([]);
    this.setMarkers([]);
    this.setLoops([]);
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
    if (!this.#view) return;
    this.#view.setPositions(positions);
    // Software rendering in tests cannot afford the shadow at every step.
    if (!this.options.test) this.#stage.shapeChanged();
    this.#redraw();
  }

  settlePositions(): void {
    this.#picker?.settle();
    this.#stage.shapeChanged();
    this.#hair.lightChanged();
    this.#redraw();
  }

  setRegions(regions: readonly RegionPaint[]): void {
    this.#regions = regions;
    this.#materials.setChannels(this.#view?.setRegions(regions) ?? [], this.#palette);
    this.#redraw();
  }

  setMarkers(markers: readonly PointMarker[]): void {
    this.#markers.set(markers, this.#space);
    this.#redraw();
  }

  setLoops(loops: readonly LoopLine[]): void {
    this.#loops.set(loops, this.#space);
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
      this.#view.mesh.material = this.#materials.of(options, sideOf(this.#view));
      this.#materials.setChannels(this.#view.setRegions(this.#regions), palette);
    }
    for (const part of [this.#stage, this.#markers, this.#loops, this.#gizmo, this.#widget]) {
      part.setPalette(palette);
    }
    this.#stage.showGrid(options.grid);
    this.#showWireframe(options.wireframe, palette);
    this.#redraw();
  }

  setBrush(brush: { readonly hit: Hit; readonly radius: number; readonly erase: boolean } | null): void {
    const { brushCentre, brushNormal, brushSide, brushRadius, brushDashed } = this.#materials.uniforms;
    if (!brush && brushRadius.value === 0) return;
    brushRadius.value = brush ? brush.radius * this.#space.scale : 0;
    if (brush) {
      this.#space.toView(brush.hit.point, brushCentre.value);
      const normal = this.#space.directionToView(brush.hit.normal, brushNormal.value);
      const apart = Math.abs(normal.y) < 0.9 ? new Vector3(0, 1, 0) : new Vector3(1, 0, 0);
      brushSide.value.crossVectors(apart, normal).normalize();
      brushDashed.value = brush.erase;
      this.#materials.setBrushColour(brush.erase ? BRUSH_ERASES : BRUSH_ADDS);
    }
    this.#redraw();
  }

  setHair(strands: Strands | null): void {
    this.#hair.setHair(strands);
    this.#hairChanged();
  }

  setHairOptions(options: Partial<HairOptions>): void {
    this.#hair.setOptions(options);
    this.#hairChanged();
  }

  setStrandShare(share: number | null): void {
    this.#hair.setShare(share);
    this.#redraw();
  }

  setCurves(curves: readonly StyleCurve[]): void {
    this.#hair.setCurves(curves);
    this.#redraw();
  }

  pickCurve(x: number, y: number): CurveHit | null {
    return this.#hair.pickCurve(x, y, (place) => this.#onScreen(place));
  }

  setField(field: FieldSample | null): void {
    this.#hair.setField(field);
    this.#redraw();
  }

  setConstraints(constraints: FieldSample | null): void {
    this.#hair.setConstraints(constraints);
    this.#redraw();
  }

  setVolume(box: Box | null): void {
    this.#hair.setVolume(box);
    this.#redraw();
  }

  setSupport(surface: SupportSurface | null): void {
    this.#hair.setSupport(surface);
    this.#redraw();
  }

  setGizmo(gizmo: GizmoState | null, events?: GizmoEvents): void {
    this.#gizmo.set(gizmo, events, this.#space);
    this.#redraw();
  }

  get gizmoBusy(): boolean {
    return this.#gizmo.busy;
  }

  pick(x: number, y: number): Hit | null {
    return this.#picker?.pick(this.#rig.ray(x, y)) ?? null;
  }

  pickMarker(x: number, y: number): string | null {
    return this.#markers.pick(x, y, MARKER_REACH, this.#space, (place) => this.#onScreen(place));
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
    this.#rig.frame(vertices ? places : [...places, ...this.#hair.places()]);
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

  /** How trackpads and palms are understood; the defaults suit a mouse and a pen. */
  setNavigation(options: Partial<NavigationOptions>): void {
    this.#input.navigation = { ...this.#input.navigation, ...options };
  }

  onDraw(listener: () => void): () => void {
    this.#drawn.add(listener);
    return () => this.#drawn.delete(listener);
  }

  get frameRate(): number {
    return this.#loop.rate;
  }

  async screenshot(width: number, height: number, options: PictureOptions = {}): Promise<Blob> {
    const { samples: wanted = this.options.test ? 1 : SCREENSHOT_SAMPLES, onProgress, signal } = options;
    const { patience = Infinity } = options;
    const samples = StillPicture.possible(this.#renderer) ? wanted : 1;
    const copy = document.createElement('canvas');
    Object.assign(copy, { width, height });
    const still = new StillPicture();
    const begun = performance.now();
    let [stirs, taken, done] = [this.#stirs, 0, false];
    try {
      while (!done) {
        signal?.throwIfAborted();
        // What has been drawn so far was another picture.
        if (stirs !== this.#stirs) {
          still.restart();
          [stirs, taken] = [this.#stirs, 0];
        }
        this.#drawAside(width, height, () => {
          if (samples > 1) still.take(this.#renderer, this.#rig.camera, (frame) => this.#render(frame));
          else this.#render(1);
          taken++;
          done = taken >= samples || (taken >= FEWEST && performance.now() - begun > patience);
          if (done) copy.getContext('2d')?.drawImage(this.canvas, 0, 0);
        });
        onProgress?.(taken / samples);
        if (!done) await breath();
      }
    } finally {
      still.dispose();
    }
    const blob = await new Promise<Blob | null>((done) => copy.toBlob(done, 'image/png'));
    if (!blob)
      throw new LissomError('screenshot-failed', 'The picture could not be made. Try a smaller size.');
    return blob;
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
      this.#markers,
      this.#loops,
      this.#hair,
      this.#stage,
      this.#materials,
      this.#renderer,
    ]) {
      part.dispose();
    }
  }

  get #space(): ViewSpace {
    return this.#hair.space;
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
    this.#markers.setPixelRatio(pixelRatio);
    this.#loops.setSize(width, height, pixelRatio);
    this.#hair.setSize(width, height, pixelRatio);
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
    this.#hair.setKept(true);
    this.#size(width, height, 1);
    this.#stage.prepare(this.#view?.geometry);
    draw();
    brushRadius.value = brush;
    this.#gizmo.visible = true;
    this.#hair.setKept(false);
    this.#size(w, h, this.#pixelRatio);
    if (!this.#rest.drawAgain()) this.#draw();
  }

  #restore(): void {
    this.#stage.restore();
    this.#hair.lightChanged();
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
      this.#hair.paced(elapsed);
    }
    return moving;
  }

  #hairChanged(): void {
    this.#materials.setHair(this.#hair.shadowUniforms);
    this.#redraw();
  }

  #draw(): void {
    if (this.#renderer.getContext().isContextLost()) return;
    this.#stage.prepare(this.#view?.geometry);
    const { camera } = this.#rig;
    this.#gizmo.setCamera(camera);
    if (this.#rest.due) this.#rest.draw(camera, (frame) => this.#render(frame));
    else {
      this.#render(0);
      if (this.#hair.shown && !this.options.test) this.#rest.wait();
    }
    this.#widget.update(camera, this.#space);
    for (const listener of this.#drawn) listener();
  }

  /** @param frame  number of a picture at rest, from 1; 0: a moving one */
  #render(frame: number): void {
    this.#wireframe?.fade(this.#rig.pixelSize(this.#rig.target));
    this.#hair.prepare(this.#rig.camera, frame);
    this.#renderer.render(this.#scene, this.#rig.camera);
  }
}

/** Lets the page and the graphics card catch up. */
const breath = (): Promise<unknown> =>
  Promise.race([new Promise(requestAnimationFrame), new Promise((rested) => setTimeout(rested, UNSEEN))]);

function rendererFor(canvas: HTMLCanvasElement, options: ViewportOptions): WebGLRenderer {
  let renderer: WebGLRenderer;
  try {
    renderer = new WebGLRenderer({
      canvas,
      antialias: !options.test,
      powerPreference: 'high-performance',
    });
  } catch {
    throw new LissomError(
      'webgl-missing',
      'This browser offers no WebGL 2. Switch hardware acceleration on in its settings, or use another browser.',
      'crash',
    );
  }
  renderer.toneMapping = ACESFilmicToneMapping;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.autoUpdate = false;
  renderer.shadowMap.type = PCFShadowMap;
  return renderer;
}

/** Closed surfaces show one side: at their outline the far side would flicker through the near one. */
function sideOf({ closed, inwards }: ModelView): Side {
  if (!closed) return DoubleSide;
  return inwards ? BackSide : FrontSide;
}
