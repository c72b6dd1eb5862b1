import type { PointerSample } from '../../view/types';
import { DragTool } from '../drag-tool';
import type { HandleDrag } from './handle-drag';
import type { DeformHost } from './host';
import { grab, placePoint } from './select-tool';

/** A click on the surface places a point handle, which may be dragged on; on a handle it works like select. */
export class PointTool extends DragTool {
  constructor(private readonly host: DeformHost) {
    super();
  }

  protected override take(sample: PointerSample): HandleDrag | null {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return null;
    return grab(this.host, scene, sample) ?? placePoint(this.host, scene, sample, sample.hit.vertex);
  }
}
