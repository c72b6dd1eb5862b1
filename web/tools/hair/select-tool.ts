import type { PointerSample } from '../../view/types';
import { type Gesture, GestureTool } from '../stroke/gesture';
import { rayAt } from '../stroke/support';
import { HintGesture } from './hint-gesture';
import type { HairHost, HairScene } from './host';
import { PointDrag } from './point-drag';
import { primitiveAt, readCurveId } from './style';
import { TiltGesture } from './tilt';

/** What the two tools below share: a click on a curve selects it, and they need no head under the pointer. */
abstract class CurveTool extends GestureTool<HairScene, HairHost> {
  override hover(): void {
    this.host.aim(true);
  }

  protected override click({ x, y }: PointerSample): boolean {
    const hit = this.host.curves.pickLine(x, y);
    if (hit) this.host.select(readCurveId(hit.id).index);
    return hit !== null;
  }
}

/** A click selects a curve; of the selected one, control points can be dragged. Elsewhere the camera turns. */
export class HairSelectTool extends CurveTool {
  protected begin(scene: HairScene, sample: PointerSample): Gesture | null {
    const hit = this.host.curves.pickLine(sample.x, sample.y);
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
      const hit = this.host.curves.pickLine(sample.x, sample.y);
      this.host.select(hit ? readCurveId(hit.id).index : null);
    };
    return { move: (samples) => hint.move(samples), finish: (last) => hint.finish(last, click) };
  }
}
