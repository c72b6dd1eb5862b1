import type { CameraState, Hit, Vec3 } from '../../view/types';
import { subtract, unit } from '../geometry';

/** The brush reaches so many radii into the model: through a neck, not to the leg behind it. */
const DEPTH = 4;

/** Vertices under a round brush that goes into the model, seen from the camera: both sides of what is thin. */
export function verticesThrough(
  positions: Float64Array,
  hit: Hit,
  radius: number,
  camera: CameraState,
): Uint32Array {
  const [x, y, z] = hit.point;
  const sight = camera.orthographic
    ? subtract(camera.target, camera.position)
    : subtract(hit.point, camera.position);
  const [dx, dy, dz]: Vec3 = unit(sight, [0, 0, -1]);
  const found: number[] = [];
  for (let v = 0; v < positions.length; v += 3) {
    const [px, py, pz] = [positions[v]! - x, positions[v + 1]! - y, positions[v + 2]! - z];
    const depth = px * dx + py * dy + pz * dz;
    if (depth < -radius || depth > DEPTH * radius) continue;
    if (px * px + py * py + pz * pz - depth * depth <= radius * radius) found.push(v / 3);
  }
  return Uint32Array.from(found);
}
