import type { PointerSample, Vec3 } from '../../view/types';
import { type Gesture, GestureTool } from '../stroke/gesture';
import { nearestOn } from '../stroke/polyline';
import { onScreen, SurfaceStroke } from '../stroke/stroke';
import { drawing } from './drawing';
import { addPrimitive, isTooShort, kept } from './edits';
import type { HairEdit, HairHost, HairRemark, HairScene } from './host';
import { nearness, PARTING_SPACING } from './measures';
import { primitiveAt } from './style';
import { TiltGesture } from './tilt';

/** What a dividing curve starts with (Fu Fig 4.4): lengths in grid steps. */
export const PARTING = { tilt: [0, 0] as [number, number], sigma: 1, height: 0.5 };

/**
 * Draws partings: a stroke on the skin. One that begins on the selected parting and leads away to a side
 * shows how the hair leans there.
 */
export class PartingTool extends GestureTool<HairScene, HairHost> {
  protected begin(scene: HairScene, sample: PointerSample): Gesture | null {
    if (!sample.hit) return null;
    if (isNearSelected(this.host, scene, sample))
      return new TiltGesture(this.host, scene, scene.selected!, sample);
    const stroke = new SurfaceStroke(this.host.view);
    const edited = () => withParting(scene, stroke);
    return drawing(this.host, { stroke, kind: 'parting', label: 'add-parting', edited }, sample);
  }
}

/** Only what lies on the skin before the stroke first leaves it. */
function withParting(scene: HairScene, stroke: SurfaceStroke): HairEdit | HairRemark {
  const line = stroke.line.slice(0, stroke.onHead);
  if (isTooShort(line, scene.height)) return 'too-short';
  const points = kept(line, scene.height, PARTING_SPACING);
  if (points.length < 2) return 'too-short';
  return addPrimitive(scene, { kind: 'parting', item: { points, ...PARTING } });
}

function isNearSelected(host: HairHost, { step, selected }: HairScene, sample: PointerSample): boolean {
  const primitive = primitiveAt(step, selected);
  if (primitive?.kind !== 'parting') return false;
  const at: Vec3 = [sample.x, sample.y, 0];
  const found = nearestOn(onScreen(host.view, primitive.item.points), at);
  return found !== undefined && found.distance <= nearness(sample.pointerType);
}
