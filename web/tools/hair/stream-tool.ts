import type { PointerSample } from '../../view/types';
import { addPrimitive, isTooShort, kept } from './edits';
import { Drawing, GestureTool } from './gesture';
import type { HairEdit, HairRemark, HairScene } from './host';
import { SPACING } from './measures';
import type { Line } from './polyline';
import { HeadStroke } from './stroke';

/** Draws stream curves: a stroke that begins on the head. The hair follows while it is drawn. */
export class StreamTool extends GestureTool {
  readonly id = 'stream';

  protected begin(scene: HairScene, sample: PointerSample): Drawing | null {
    if (!sample.hit) return null;
    const stroke = new HeadStroke(this.host.view);
    const edited = () => withStream(scene, stroke.line);
    return new Drawing(this.host, { stroke, kind: 'stream', label: 'add-stream', edited }, sample);
  }
}

function withStream(scene: HairScene, line: Line): HairEdit | HairRemark {
  if (isTooShort(line, scene.height)) return 'too-short';
  const points = kept(line, scene.height, SPACING);
  if (points.length < 2) return 'too-short';
  return addPrimitive(scene, { kind: 'stream', item: { points, fade: false } });
}
