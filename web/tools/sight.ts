import type { Vec3, ViewportPort } from '../view/types';
import { gap } from './geometry';

/** A point is hidden when the surface in front of it is nearer by this part of the distance. */
const BEHIND = 0.01;

/** Whether something stands between the eye and a point on the model. */
export function isHidden(view: Pick<ViewportPort, 'project' | 'pick' | 'camera'>, point: Vec3): boolean {
  const { x, y, behind } = view.project(point);
  if (behind) return true;
  const hit = view.pick(x, y);
  return hit !== null && gap(view.camera.position, point) - hit.distance > BEHIND * hit.distance;
}
