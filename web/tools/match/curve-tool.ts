// Marker curves: a line drawn on each model, which belong together from end to end.

import type { MarkerPlace } from '../../recipe/steps/match';
import type { PointerSample } from '../../view/types';
import { type Drag, DragTool } from '../drag-tool';
import { lengthOf, resampled, smoothed } from '../stroke/polyline';
import { SurfaceStroke } from '../stroke/stroke';
import { curveFor } from './edits';
import type { MatchHost, MatchScene } from './host';
import { nearestSpot } from './places';

/** Places that are kept of a line: enough for an eyelid or a collar. */
const MOST = 24;
/** CSS pixels between two of them at least, and in a line that is one. */
const APART = 7;
const SHORTEST = 12;

export class CurveTool extends DragTool {
  constructor(private readonly host: MatchHost) {
    super();
  }

  protected take(sample: PointerSample): Drag | null {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return null;
    return new CurveDrawing(this.host, scene, sample);
  }

  override cancel(): void {
    super.cancel();
    this.host.showLine(null);
  }
}

class CurveDrawing implements Drag {
  readonly #stroke: SurfaceStroke;

  constructor(
    private readonly host: MatchHost,
    private readonly scene: MatchScene,
    first: PointerSample,
  ) {
    this.#stroke = new SurfaceStroke(host.view);
    this.move([first]);
  }

  /** Off the model a line has no place. */
  move(samples: readonly PointerSample[]): void {
    this.#stroke.extend(samples.filter(({ hit }) => hit));
    this.host.showLine(this.#stroke.line);
  }

  finish(sample: PointerSample): void {
    this.move([sample]);
    const { host, scene } = this;
    host.showLine(null);
    const { line, seen } = this.#stroke;
    const across = lengthOf(seen);
    if (across < SHORTEST) {
      host.tooShort();
      return;
    }
    const pieces = Math.min(MOST - 1, Math.max(1, Math.round(across / APART)));
    const even = resampled(smoothed(line, 2), lengthOf(line) / pieces);
    const row = even.flatMap((point): MarkerPlace[] => {
      const found = nearestSpot(scene.surface, point);
      return found ? [found.spot.place] : [];
    });
    host.commitCurve(curveFor(scene.step, scene.curve), row);
  }

  cancel(): void {
    this.host.showLine(null);
  }
}
