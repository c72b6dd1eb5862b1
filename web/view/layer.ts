// What is drawn beside the model comes in layers: each is put into the picture and taken out as a whole, and the
// viewport knows none of them by name.

import type { Group, OrthographicCamera, PerspectiveCamera, Vector3, WebGLRenderer } from 'three';
import type { ModelView } from './model-view';
import type { Palette } from './palette';
import type { SurfaceShade } from './surface-shade';
import type { ViewSpace } from './view-space';

/** What a layer is given of the viewport it is in. */
export interface LayerContext {
  readonly renderer: WebGLRenderer;
  /** For tests: one sample a pixel, and every picture is a finished one. */
  readonly test: boolean;
  /** Something looks different now. */
  redraw(): void;
  /** The model is drawn in another shape: its shadows follow. */
  reshaped(): void;
  /** The layer's own space may be another one. If the picture's follows it, every layer is placed anew. */
  settle(): void;
  /** A drawn place in CSS pixels from the top left corner; z < 0 behind the eye. */
  onScreen(place: Vector3): Vector3;
}

/** One layer in a picture. All but `group`, `place` and `dispose` is for those that need it. */
export interface Layer {
  readonly group: Group;
  /** Helps to work, and is no part of a picture to keep. */
  readonly aid?: boolean;
  /** Its pictures have no ground: neither grid nor shadows. */
  readonly bare?: boolean;
  /** How it changes the look of the surfaces it stands over; undefined while it does not. */
  readonly shade?: SurfaceShade | undefined;
  /** Its pictures become better while nothing moves. */
  readonly refines?: boolean;
  /** Where to draw; called at first, and whenever space or model is another one. Marks on one model mean nothing on another. */
  place(space: ViewSpace, model: ModelView | undefined): void;
  /** The space to draw in when no model is shown. */
  ownSpace?(): ViewSpace | undefined;
  /** What should be in sight when everything is, 3 numbers per place, drawn units. */
  extent?(): ArrayLike<number>;
  setPalette?(palette: Palette): void;
  /** @param width, height  CSS pixels */
  resize?(width: number, height: number, pixelRatio: number): void;
  /** The model has come to rest in another shape. */
  modelSettled?(): void;
  /** The graphics card has forgotten what was drawn into textures. */
  restore?(): void;
  /** A picture to keep is being made, or is made. */
  setKept?(kept: boolean): void;
  /** The last moving picture took so many ms. */
  paced?(elapsed: number): void;
  /**
   * Just before a picture.
   *
   * @param frame  number of a picture at rest, from 1; 0: a moving one
   */
  prepare?(camera: PerspectiveCamera | OrthographicCamera, frame: number): void;
  /** Gives back all that it holds on the graphics card. */
  dispose(): void;
}

/** A kind of layer, and by `P` what one can ask of it. */
export interface LayerKind<P> {
  /** By this tests answer in its place. */
  readonly id: string;
  readonly make: (context: LayerContext) => Layer & P;
}

/** A layer in a picture. */
export interface Mounted<P> {
  readonly port: P;
  /** Takes it out of the picture and frees what it held. */
  unmount(): void;
}
