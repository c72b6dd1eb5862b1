import type { PointerSample, Vec3 } from '../../view/types';
import { DragTool } from '../drag-tool';
import { pointAt } from '../geometry';
import { addPoint, handleAt } from './edits';
import { HandleDrag } from './handle-drag';
import { type DeformHost, type DeformScene, handleOfMarker } from './host';

/** Click selects a handle, drag moves it, Shift+click places a point handle; elsewhere the camera turns. */
export class SelectTool extends DragTool {
  constructor(private readonly host: DeformHost) {
    super();
  }

  protected override take(sample: PointerSample): HandleDrag | null {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0) return null;
    const grabbed = grab(this.host, scene, sample);
    if (grabbed) return grabbed;
    return sample.shift && sample.hit ? placePoint(this.host, scene, sample, sample.hit.vertex) : null;
  }
}

/** A press on a handle: dragged on it moves, else it is selected. */
export function grab(host: DeformHost, scene: DeformScene, sample: PointerSample): HandleDrag | null {
  const held = handleUnder(host, scene, sample);
  if (!held) return null;
  const { index, grip } = held;
  return new HandleDrag(host, scene.step, index, sample, grip, 'move-handle', () => host.select(index));
}

/** The handle under the pointer and the point of it that is held. */
function handleUnder(
  host: DeformHost,
  scene: DeformScene,
  sample: PointerSample,
): { readonly index: number; readonly grip: Vec3 } | null {
  const marker = host.markers.pickMarker(sample.x, sample.y);
  if (marker !== null) {
    const index = handleOfMarker(marker);
    const handle = scene.step.handles[index];
    if (handle?.kind === 'point') return { index, grip: handle.position };
  }
  if (!sample.hit) return null;
  const index = handleAt(scene.step, sample.hit.vertex, scene.rest.length / 3);
  return index < 0 ? null : { index, grip: sample.hit.point };
}

/** A press that places a point handle; dragging on moves it at once, and all of it is one step of undo. */
export function placePoint(host: DeformHost, scene: DeformScene, sample: PointerSample, vertex: number) {
  const placed = addPoint(scene, vertex, host.newName(scene.step));
  const grip = pointAt(scene.posed, vertex);
  return new HandleDrag(host, placed.step, scene.step.handles.length, sample, grip, 'add-point', () =>
    host.commit('add-point', placed),
  );
}
