// The surface that gives strokes beside a curve their depth (Fu 4.5, Fig 4.3 a and b).

import type { CameraState, Vec3, ViewportPort } from '../../view/types';
import { add, cross, dot, gap, mix, norm, scaled, subtract, unit } from '../geometry';
import type { Line } from './polyline';

/** `ruled`: through the curve and the viewpoint; `strip`: lines across each triangle of segment and viewpoint. */
export type SupportKind = 'ruled' | 'strip';

/** Where one looks from; for a parallel view only the direction counts. */
export interface Viewpoint {
  readonly eye: Vec3;
  readonly direction: Vec3;
  readonly orthographic: boolean;
}

export interface Ray {
  readonly origin: Vec3;
  /** Unit length. */
  readonly direction: Vec3;
}

export const viewpointOf = ({ position, target, orthographic }: CameraState): Viewpoint => ({
  eye: position,
  direction: unit(subtract(target, position), [0, 0, -1]),
  orthographic,
});

/** The ray of sight through a place on the screen. */
export function rayAt(view: Pick<ViewportPort, 'camera' | 'pointOnScreenPlane'>, x: number, y: number): Ray {
  const { position, target, orthographic } = view.camera;
  const through = view.pointOnScreenPlane(x, y, target);
  const ahead = unit(subtract(target, position), [0, 0, -1]);
  return orthographic
    ? { origin: subtract(through, scaled(ahead, gap(position, target))), direction: ahead }
    : { origin: position, direction: unit(subtract(through, position), ahead) };
}

/** A ribbon of quads along a curve: one ruling through each of its points, `reach` to either side. */
export class SupportSurface {
  /** 3 per vertex: for each point of the curve the two ends of its ruling. */
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;

  constructor(
    readonly line: Line,
    viewpoint: Viewpoint,
    readonly kind: SupportKind,
    readonly reach: number,
  ) {
    const rulings = line.map((point, i) => ruling(line, i, point, viewpoint, kind));
    // A curve seen end on has no side there; its neighbours know one.
    for (let i = 1; i < rulings.length; i++) {
      if (norm(rulings[i]!) === 0) rulings[i] = rulings[i - 1]!;
      if (dot(rulings[i]!, rulings[i - 1]!) < 0) rulings[i] = scaled(rulings[i]!, -1);
    }
    this.positions = new Float64Array(6 * line.length);
    line.forEach((point, i) => {
      this.positions.set(subtract(point, scaled(rulings[i]!, reach)), 6 * i);
      this.positions.set(add(point, scaled(rulings[i]!, reach)), 6 * i + 3);
    });
    this.triangles = new Uint32Array(
      line.slice(1).flatMap((_, i) => [2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2]),
    );
  }

  /** Where the ray meets the ribbon; of several places the one nearest to the curve. */
  meet({ origin, direction }: Ray): Vec3 | null {
    let best: Vec3 | null = null;
    let least = Infinity;
    for (let t = 0; t < this.triangles.length; t += 3) {
      const corners = [0, 1, 2].map((k) => this.#corner(this.triangles[t + k]!)) as [Vec3, Vec3, Vec3];
      const point = meetTriangle(origin, direction, corners);
      if (!point) continue;
      const segment = Math.floor(t / 6);
      const off = gap(point, closest(this.line[segment]!, this.line[segment + 1]!, point));
      if (off < least) [best, least] = [point, off];
    }
    return best;
  }

  #corner(vertex: number): Vec3 {
    const at = 3 * vertex;
    return [this.positions[at]!, this.positions[at + 1]!, this.positions[at + 2]!];
  }
}

/** Direction of the line of the surface that passes through a point of the curve. */
function ruling(line: Line, i: number, point: Vec3, viewpoint: Viewpoint, kind: SupportKind): Vec3 {
  const sight = viewpoint.orthographic ? viewpoint.direction : unit(subtract(point, viewpoint.eye));
  if (kind === 'ruled') return sight;
  const tangent = subtract(line[Math.min(i + 1, line.length - 1)]!, line[Math.max(0, i - 1)]!);
  return unit(cross(tangent, sight));
}

function closest(a: Vec3, b: Vec3, to: Vec3): Vec3 {
  const along = subtract(b, a);
  const squared = dot(along, along);
  return mix(a, b, squared > 0 ? Math.min(1, Math.max(0, dot(subtract(to, a), along) / squared)) : 0);
}

/** Möller–Trumbore, both sides. */
function meetTriangle(origin: Vec3, direction: Vec3, [a, b, c]: readonly [Vec3, Vec3, Vec3]): Vec3 | null {
  const [u, v] = [subtract(b, a), subtract(c, a)];
  const across = cross(direction, v);
  const determinant = dot(u, across);
  // Relative to the sizes that went in: a triangle seen edge on is passed by.
  if (Math.abs(determinant) <= 1e-12 * norm(u) * norm(v)) return null;
  const to = subtract(origin, a);
  const s = dot(to, across) / determinant;
  const other = cross(to, u);
  const r = dot(direction, other) / determinant;
  const t = dot(v, other) / determinant;
  const edge = -1e-9;
  if (s < edge || r < edge || s + r > 1 - edge || t <= 0) return null;
  return add(origin, scaled(direction, t));
}
