import type { PointerSample } from '../../view/types';
import { type Gesture, GestureTool } from '../stroke/gesture';
import type { Line } from '../stroke/polyline';
import { SurfaceStroke } from '../stroke/stroke';
import { drawing } from './drawing';
import { addPrimitive, isTooShort, kept } from './edits';
import type { HairEdit, HairHost, HairRemark, HairScene } from './host';
import { SPACING } from './measures';

/** Draws stream curves: a stroke that begins on the head. The hair follows while it is drawn. */
export class StreamTool extends GestureTool<HairScene, HairHost> {
  protected begin(scene: HairScene, sample: PointerSample): Gesture | null {
    if (!sample.hit) return null;
    const stroke = new SurfaceStroke(this.host.view);
    const edited = () => withStream(scene, stroke.line);
    return drawing(this.host, { stroke, kind: 'stream', label: 'add-stream', edited }, sample);
  }
}

function withStream(scene: HairScene, line: Line): HairEdit | HairRemark {
  if (isTooShort(line, scene.height)) return 'too-short';
  const points = kept(line, scene.height, SPACING);
  if (points.length < 2) return 'too-short';
  return addPrimitive(scene, { kind: 'stream', item: { points, fade: false } });
}
