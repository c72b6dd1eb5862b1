// What the floors above know of the view: plain data in, plain data out, no three.js types.

import type { Tint } from './palette';

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
  readonly tint: Tint;
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
  /** The third axis alone. */
  readonly single?: boolean;
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
  /** Pictures averaged: smoother edges, and that much longer. */
  readonly samples?: number;
  /** After so many ms a few will do. */
  readonly patience?: number;
  /** @param fraction  in [0, 1] */
  readonly onProgress?: (fraction: number) => void;
  readonly signal?: AbortSignal;
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
