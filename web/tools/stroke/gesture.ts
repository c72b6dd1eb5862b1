// What tools that draw have in common: a press begins a gesture, and most gestures are one stroke.

import type { PointerSample } from '../../view/types';
import type { Tool } from '../tool';
import type { Line } from './polyline';
import type { SupportStroke, SurfaceStroke } from './stroke';

export interface Gesture {
  move(samples: readonly PointerSample[]): void;
  finish(sample: PointerSample): void;
}

/** What a tool of gestures needs of the app, whatever it draws. */
export interface GestureHost<Scene> {
  /** `null` while there is nothing to draw on. */
  scene(): Scene | null;
  /** Shows a stroke under way that is no edit yet; `null` ends it. */
  showStroke(stroke: null): void;
  /** Drops the preview: as if the gesture had never begun. */
  cancel(): void;
  /** Whether the pointer is over something a drawing tool can start on. */
  aim(onSurface: boolean): void;
}

/** A tool that is a choice of gestures; where none begins, the camera has the pointer. */
export abstract class GestureTool<Scene, Host extends GestureHost<Scene>> implements Tool {
  #gesture: Gesture | null = null;

  constructor(protected readonly host: Host) {}

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0) return false;
    this.#gesture = this.begin(scene, sample);
    return this.#gesture !== null || this.click(sample);
  }

  move(samples: readonly PointerSample[]): void {
    this.#gesture?.move(samples);
  }

  up(sample: PointerSample): void {
    const gesture = this.#gesture;
    this.#gesture = null;
    gesture?.finish(sample);
  }

  hover(sample: PointerSample): void {
    this.host.aim(sample.hit !== null);
  }

  leave(): void {
    this.host.aim(true);
  }

  cancel(): void {
    this.#gesture = null;
    this.host.showStroke(null);
    this.host.cancel();
  }

  protected abstract begin(scene: Scene, sample: PointerSample): Gesture | null;

  /** A press that begins no gesture. @returns whether it is taken */
  protected click(_sample: PointerSample): boolean {
    return false;
  }
}

/** What one stroke needs of the app: edits under way and done, and a word about one that came to nothing. */
export interface DrawingHost<Edit extends object, Label, Remark extends string, Kind> {
  showStroke(stroke: { readonly line: Line; readonly kind: Kind } | null): void;
  preview(edit: Edit): void;
  commit(label: Label, edit: Edit): void;
  cancel(): void;
  say(remark: Remark): void;
}

/** A stroke and what it is to become. */
export interface Drawn<Edit extends object, Label, Remark extends string, Kind> {
  readonly stroke: SurfaceStroke | SupportStroke;
  readonly kind: Kind;
  readonly label: Label;
  /** What the stroke so far makes of the step, or why it makes nothing. */
  edited(): Edit | Remark;
  /** Called before a finished stroke becomes an edit. */
  finished?(): void;
}

/** One stroke from press to release; its edit is previewed while it is drawn. */
export class Drawing<Edit extends object, Label, Remark extends string, Kind> implements Gesture {
  constructor(
    private readonly host: DrawingHost<Edit, Label, Remark, Kind>,
    private readonly drawn: Drawn<Edit, Label, Remark, Kind>,
    first: PointerSample,
  ) {
    this.move([first]);
  }

  move(samples: readonly PointerSample[]): void {
    const { stroke, kind } = this.drawn;
    stroke.extend(samples);
    this.host.showStroke({ line: stroke.line, kind });
    const edit = this.drawn.edited();
    if (typeof edit === 'object') this.host.preview(edit);
  }

  finish(last: PointerSample): void {
    const { host, drawn } = this;
    drawn.stroke.extend([last]);
    host.showStroke(null);
    const edit = drawn.edited();
    if (typeof edit === 'object') {
      drawn.finished?.();
      host.commit(drawn.label, edit);
      return;
    }
    host.cancel();
    host.say(edit);
  }
}
