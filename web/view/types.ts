// What the floors above know of the view: plain data in, plain data out, no three.js types.

import type { HairPort } from './hair/types';

export type Vec3 = readonly [number, number, number];

/** Where a ray met the model. Model space. */
export interface Hit {
  readonly point: Vec3;
  readonly normal: Vec3;
  /** Display triangle and its vertex nearest to the point (source index). */
  readonly triangle: number;
  readonly vertex: number;
  readonly distance: number;
}

/** A pointer event as tools see it: picked against the model, coalesced samples kept apart. */
export interface PointerSample {
  /** CSS pixels from the top left corner of the viewport. */
  readonly x: number;
  readonly y: number;
  /** 0..1; 0.5 for a mouse. */
  readonly pressure: number;
  readonly pointerType: 'mouse' | 'pen' | 'touch';
  readonly button: number;
  readonly shift: boolean;
  readonly alt: boolean;
  readonly ctrl: boolean;
  readonly hit: Hit | null;
}

export interface RegionPaint {
  readonly id: string;
  /** Source vertices. */
  readonly vertices: Uint32Array;
  readonly kind: 'roi' | 'handle' | 'source' | 'feature' | 'target' | 'scalp';
  readonly visible: boolean;
  readonly selected: boolean;
}

export interface PointMarker {
  readonly id: string;
  readonly position: Vec3;
  readonly visible: boolean;
  readonly selected: boolean;
}

/** What the viewport shows of a model, beside its shape. */
export interface DisplayOptions {
  readonly shading:
    | 'clay'
    | 'matcap-clay'
    | 'matcap-pearl'
    | 'matcap-jade'
    | 'matcap-graphite'
    | 'vertex-colours';
  readonly smooth: boolean;
  readonly wireframe: boolean;
  readonly grid: boolean;
  readonly theme: 'dark' | 'light';
}

export type GizmoMode = 'translate' | 'rotate' | 'scale';

/** A model ready to draw: source vertices, the kernel's triangles over them, the file's own edges. */
export interface ViewModel {
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
  readonly faceOffsets: Uint32Array;
  readonly faceVertices: Uint32Array;
  /** Per source vertex its welded vertex, −1 none: normals are smooth across format seams. */
  readonly welded: Int32Array;
  /** RGBA 0–255. */
  readonly colors?: Uint8Array;
  /** How the file's axes lie; the view turns a z-up model upright without touching its numbers. */
  readonly upAxis?: 'y' | 'z';
}

/** A closed line on the surface. */
export interface LoopLine {
  /** 3 per point, model space; the last is joined to the first. */
  readonly points: Float64Array;
  readonly kind: 'source' | 'target' | 'open';
  /** Under the pointer, or picked: wider. */
  readonly strong: boolean;
}

export interface CameraState {
  readonly position: Vec3;
  readonly target: Vec3;
  readonly orthographic: boolean;
}

export type ViewPreset = 'home' | 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom';

export interface GizmoState {
  /** Column-major 4×4: where the gizmo stands now, model space. */
  readonly matrix: readonly number[];
  readonly mode: GizmoMode;
}

export interface GizmoEvents {
  readonly onStart: () => void;
  /** Every move; `matrix` is the gizmo's new column-major 4×4. */
  readonly onChange: (matrix: readonly number[]) => void;
  readonly onEnd: () => void;
  /** Escape or a lost pointer: as if the drag had never begun. Without it, `onChange` with the first matrix and `onEnd`. */
  readonly onCancel?: () => void;
}

export interface PictureOptions {
  /** Pictures averaged: smoother hair and edges, and that much longer. */
  readonly samples?: number;
  /** After so many ms a few will do. */
  readonly patience?: number;
  /** @param fraction  in [0, 1] */
  readonly onProgress?: (fraction: number) => void;
  readonly signal?: AbortSignal;
}

/** What tools and app use of the viewport. Implemented by `Viewport` in viewport.ts; tests use doubles. */
export interface ViewportPort extends HairPort {
  /** Shows a model (rest shape); the camera frames it unless `keepCamera`. */
  setModel(model: ViewModel | null, options?: { readonly keepCamera?: boolean }): void;
  /** New places for the same vertices (3 per source vertex), live: normals and GPU arrays only. */
  setPositions(positions: Float64Array): void;
  /** After the last of a run of setPositions: refits picking. */
  settlePositions(): void;
  setRegions(regions: readonly RegionPaint[]): void;
  setMarkers(markers: readonly PointMarker[]): void;
  setLoops(loops: readonly LoopLine[]): void;
  /** Colours by a value per source vertex, with the perceptual map whose legend is at `heatGradient()`. */
  setHeat(heat: { readonly values: Float32Array; readonly range: readonly [number, number] } | null): void;
  setDisplay(options: DisplayOptions): void;
  /** The ring lies on the surface at `hit`, radius in model units. */
  setBrush(brush: { readonly hit: Hit; readonly radius: number; readonly erase: boolean } | null): void;
  setGizmo(gizmo: GizmoState | null, events?: GizmoEvents): void;
  /** True while the pointer is over or drags the gizmo: tools keep quiet. */
  readonly gizmoBusy: boolean;
  /** Against the model as now posed. CSS pixels from the viewport's top left corner. */
  pick(x: number, y: number): Hit | null;
  pickMarker(x: number, y: number): string | null;
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
  dispose(): void;
}

export interface PointerHandler {
  /** @returns true to take the gesture (the camera keeps still), false to let the camera have it */
  down(sample: PointerSample): boolean;
  /** All coalesced samples since the last call, oldest first. Only while the gesture is taken. */
  move(samples: readonly PointerSample[]): void;
  up(sample: PointerSample): void;
  /** No button pressed. */
  hover(sample: PointerSample): void;
  leave(): void;
  /** Escape, lost capture, a second finger: as if the gesture had never begun. */
  cancel(): void;
}
