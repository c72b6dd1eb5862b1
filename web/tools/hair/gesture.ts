// What the hair tools have in common: a press begins a gesture, and most gestures are one stroke.

import type { PointerSample } from '../../view/types';
import type { Tool } from '../tool';
import type { HairEdit, HairEditLabel, HairHost, HairRemark, HairScene } from './host';
import type { HeadStroke, SupportStroke } from './stroke';
import type { CurveKind } from './style';

export interface Gesture {
  move(samples: readonly PointerSample[]): void;
  finish(sample: PointerSample): void;
}

/** A tool that is a choice of gestures; where none begins, the camera has the pointer. */
export abstract class GestureTool implements Tool {
  abstract readonly id: string;
  #gesture: Gesture | null = null;

  constructor(protected readonly host: HairHost) {}

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

  protected abstract begin(scene: HairScene, sample: PointerSample): Gesture | null;

  /** A press that begins no gesture. @returns whether it is taken */
  protected click(_sample: PointerSample): boolean {
    return false;
  }
}

/** A stroke and what it is to become. */
export interface Drawn {
  readonly stroke: HeadStroke | SupportStroke;
  readonly kind: CurveKind;
  readonly label: HairEditLabel;
  /** What the stroke so far makes of the step, or why it makes nothing. */
  edited(): HairEdit | HairRemark;
}

/** One stroke from press to release, which the hair follows while it is drawn. */
export class Drawing implements Gesture {
  constructor(
    private readonly host: HairHost,
    private readonly drawn: Drawn,
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
      // A new curve is edited on a surface that faces whoever drew it.
      if (drawn.label.startsWith('add-')) host.rebuildSupport();
      host.commit(drawn.label, edit);
      return;
    }
    host.cancel();
    host.say(edit);
  }
}
