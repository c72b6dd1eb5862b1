import type { PointerSample } from '../../view/types';
import type { Tool } from '../tool';
import { HintGesture } from './hint-gesture';
import type { HairHost, HairScene } from './host';
import { PointDrag } from './point-drag';
import { primitiveAt, readCurveId } from './style';
import { rayAt } from './support';
import { TiltGesture } from './tilt';

interface Gesture {
  move(samples: readonly PointerSample[]): void;
  finish(sample: PointerSample): void;
}

/** What the two tools below share: a press may begin a gesture; a click on a curve selects it. */
abstract class CurveTool implements Tool {
  abstract readonly id: string;
  #gesture: Gesture | null = null;

  constructor(protected readonly host: HairHost) {}

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0) return false;
    this.#gesture = this.begin(scene, sample);
    if (this.#gesture) return true;
    const hit = this.host.view.pickCurve(sample.x, sample.y);
    if (hit) this.host.select(readCurveId(hit.id).index);
    return hit !== null;
  }

  move(samples: readonly PointerSample[]): void {
    this.#gesture?.move(samples);
  }

  up(sample: PointerSample): void {
    const gesture = this.#gesture;
    this.#gesture = null;
    gesture?.finish(sample);
  }

  hover(): void {
    this.host.aim(true);
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
}

/** A click selects a curve; of the selected one, control points can be dragged. Elsewhere the camera turns. */
export class HairSelectTool extends CurveTool {
  readonly id = 'hair-select';

  protected begin(scene: HairScene, sample: PointerSample): Gesture | null {
    const hit = this.host.view.pickCurve(sample.x, sample.y);
    const curve = hit && readCurveId(hit.id);
    if (!hit || !curve || curve.index !== scene.selected || hit.point === null) return null;
    return new PointDrag(this.host, scene, { ...curve, point: hit.point }, sample);
  }
}

/**
 * Edits the selected curve by hint strokes on its supporting surface; beside a parting a stroke shows how
 * the hair leans. A click on another curve selects that one. Elsewhere the camera turns.
 */
export class HintTool extends CurveTool {
  readonly id = 'hint';

  protected begin(scene: HairScene, sample: PointerSample): Gesture | null {
    const { selected, step } = scene;
    const primitive = primitiveAt(step, selected);
    if (selected === null || !primitive) return null;
    const support = this.host.support();
    if (!support?.meet(rayAt(this.host.view, sample.x, sample.y))) return null;
    if (primitive.kind === 'parting')
      return sample.hit ? new TiltGesture(this.host, scene, selected, sample) : null;
    const hint = new HintGesture(this.host, scene, selected, support, sample);
    const click = () => {
      const hit = this.host.view.pickCurve(sample.x, sample.y);
      this.host.select(hit ? readCurveId(hit.id).index : null);
    };
    return { move: (samples) => hint.move(samples), finish: (last) => hint.finish(last, click) };
  }
}
