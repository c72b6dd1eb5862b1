// What the floors above know of the view: plain data in, plain data out, and the viewport's port.

import type { LayerKind, Mounted } from './layer';
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

export type * from './values';

/** What tools and app use of the viewport. Implemented by `Viewport` in viewport.ts; tests use doubles. */
export interface ViewportPort {
  /** Shows a model (rest shape); the camera frames it unless `keepCamera`. */
  setModel(model: ViewModel | null, options?: { readonly keepCamera?: boolean }): void;
  /** New places for the same vertices (3 per source vertex), live: normals and GPU arrays only. */
  setPositions(positions: Float64Array): void;
  /** After the last of a run of setPositions: refits picking. */
  settlePositions(): void;
  setRegions(regions: readonly RegionPaint[]): void;
  /** Colours by a value per source vertex, with the perceptual map whose legend is at `heatGradient()`. */
  setHeat(heat: { readonly values: Float32Array; readonly range: readonly [number, number] } | null): void;
  setDisplay(options: DisplayOptions): void;
  /** The ring lies on the surface at `hit`, radius in model units. */
  setBrush(brush: { readonly hit: Hit; readonly radius: number; readonly erase: boolean } | null): void;
  setGizmo(gizmo: GizmoState | null, events?: GizmoEvents): void;
  /** Puts a layer into the picture, until it is taken out again. */
  mount<P>(kind: LayerKind<P>): Mounted<P>;
  /** Against the model as now posed. CSS pixels from the viewport's top left corner. */
  pick(x: number, y: number): Hit | null;
  /** Source vertices within `radius` of the hit, connected to it through the surface inside that ball. */
  verticesWithin(hit: Hit, radius: number): Uint32Array;
  /** The point under (x, y) on the plane through `through` that faces the camera. Model space. */
  pointOnScreenPlane(x: number, y: number, through: Vec3): Vec3;
  project(point: Vec3): { readonly x: number; readonly y: number; readonly behind: boolean };
  /** Model units that one CSS pixel spans at `point`. */
  pixelSize(point: Vec3): number;
  fit(vertices?: Uint32Array): void;
  /** Looks from there, at the whole model. */
  setView(preset: ViewPreset): void;
  camera: CameraState;
  /** One handler at a time. A left, pen or one-finger press is offered to it first. */
  setPointerHandler(handler: PointerHandler | null): void;
  /** After each picture, for what is laid over it. @returns the function that unsubscribes */
  onDraw(listener: () => void): () => void;
  /** Frames drawn in the last second; 0 at rest (drawing is on demand). */
  readonly frameRate: number;
  /** CSS pixels. */
  readonly size: { readonly width: number; readonly height: number };
  /** A PNG of what is seen, without tools. The page stays at hand; what changes meanwhile starts it over. */
  screenshot(width: number, height: number, options?: PictureOptions): Promise<Blob>;
  /** A small picture of the model with its vertices at other places, without tints and tools, from the home view. */
  thumbnail(positions: Float64Array, width: number, height: number): Promise<Blob>;
  dispose(): void;
}
