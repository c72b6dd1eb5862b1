import { toIndices } from '../../core/vertex-set';
import type { DeformHandle } from '../../recipe/recipe';
import type { GizmoEvents, GizmoMode } from '../../view/types';
import {
  centroid,
  IDENTITY,
  invert,
  type Mat4,
  multiply,
  position,
  rotationOf,
  transform,
  translation,
} from '../geometry';
import { moveHandle, withHandle } from './edits';
import type { DeformEdit, DeformHost, DeformScene, EditLabel } from './host';

const LABELS: Record<GizmoMode, EditLabel> = {
  translate: 'move-handle',
  rotate: 'rotate-handle',
  scale: 'scale-handle',
};

/** Where the gizmo stands on a handle: at its middle, turned as the handle is turned, without its scale. */
export function gizmoFrame(handle: DeformHandle, rest: Float64Array): Mat4 {
  if (handle.kind === 'point') return translation(handle.position);
  const pivot = centroid(rest, toIndices(handle.vertices, rest.length / 3));
  return multiply(translation(transform(handle.matrix, pivot)), rotationOf(handle.matrix));
}

/** One drag of the gizmo after another: each moves the handle by what the gizmo moved since it was taken. */
export class GizmoDrag implements GizmoEvents {
  #grip: { readonly scene: DeformScene; readonly index: number; readonly undo: Mat4 } | null = null;
  #latest: DeformEdit | null = null;

  constructor(
    private readonly host: DeformHost,
    private readonly mode: () => GizmoMode,
  ) {}

  onStart = (): void => {
    this.#grip = null;
    this.#latest = null;
    const scene = this.host.scene();
    const handle = scene && scene.selected !== null ? scene.step.handles[scene.selected] : undefined;
    if (!scene || scene.selected === null || !handle) return;
    const undo = invert(gizmoFrame(handle, scene.rest));
    if (undo) this.#grip = { scene, index: scene.selected, undo };
  };

  onChange = (matrix: Mat4): void => {
    if (!this.#grip) return;
    const { scene, index, undo } = this.#grip;
    const handle = scene.step.handles[index] as DeformHandle;
    const delta = multiply(matrix, undo);
    if (isNothing(delta, matrix)) {
      this.#latest = null;
      this.host.cancel();
      return;
    }
    const step = withHandle(scene.step, index, moveHandle(handle, delta));
    this.#latest = { step, selected: index };
    this.host.preview(this.#latest);
  };

  onEnd = (): void => {
    const latest = this.#latest;
    this.#grip = null;
    this.#latest = null;
    if (latest) this.host.commit(LABELS[this.mode()], latest);
  };

  /** Escape while the gizmo is held. */
  onCancel = (): void => {
    if (!this.#grip) return;
    this.#grip = null;
    this.#latest = null;
    this.host.cancel();
  };
}

/** Whether the gizmo is back where it was taken, as after Escape: no edit, whatever rounding left. */
function isNothing(delta: Mat4, matrix: Mat4): boolean {
  const size = Math.max(1e-30, ...position(matrix).map(Math.abs));
  return delta.every((x, i) => Math.abs(x - IDENTITY[i]!) <= 1e-9 * (i < 12 ? 1 : size));
}
