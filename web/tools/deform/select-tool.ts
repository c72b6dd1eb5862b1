import type { PointerSample, Vec3 } from '../../view/types';
import { pointAt } from '../geometry';
import type { Tool } from '../tool';
import { addPoint, handleAt } from './edits';
import { HandleDrag } from './handle-drag';
import { type DeformHost, type DeformScene, handleOfMarker } from './host';

/** Click selects a handle, drag moves it, Shift+click places a point handle; elsewhere the camera turns. */
export class SelectTool implements Tool {
  #drag: HandleDrag | null = null;

  constructor(private readonly host: DeformHost) {}

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0) return false;
    const grabbed = grab(this.host, scene, sample);
    if (grabbed) {
      const { index, grip } = grabbed;
      this.#drag = new HandleDrag(this.host, scene.step, index, sample, grip, 'move-handle', () =>
        this.host.select(index),
      );
      return true;
    }
    if (!sample.shift || !sample.hit) return false;
    this.#drag = placePoint(this.host, scene, sample, sample.hit.vertex);
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    this.#drag?.move(samples);
  }

  up(sample: PointerSample): void {
    const drag = this.#drag;
    this.#drag = null;
    drag?.finish(sample);
  }

  hover(): void {}

  leave(): void {}

  cancel(): void {
    this.#drag?.cancel();
    this.#drag = null;
  }
}

/** The handle under the pointer and the point of it that is held. */
export function grab(
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
