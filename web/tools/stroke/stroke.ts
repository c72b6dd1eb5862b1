// A stroke on its way from the screen into space: where each of its points lies in depth (Fu 4.5).

import type { PointerSample, Vec3, ViewportPort } from '../../view/types';
import { add, dot, gap, mix, scaled, subtract, unit } from '../geometry';
import { type Line, nearestOn } from './polyline';
import { rayAt, type SupportSurface } from './support';

export type StrokeView = Pick<ViewportPort, 'camera' | 'pointOnScreenPlane' | 'project'>;

/** Samples nearer to the last one than this add nothing, in CSS pixels. */
const STILL = 1.5;

abstract class Stroke {
  readonly #seen: Vec3[] = [];
  readonly #line: Vec3[] = [];

  constructor(protected readonly view: StrokeView) {}

  /** In model space, as drawn. */
  get line(): Line {
    return this.#line;
  }

  /** The same points on the screen, in CSS pixels. */
  get seen(): Line {
    return this.#seen;
  }

  extend(samples: readonly PointerSample[]): void {
    for (const sample of samples) {
      const seen: Vec3 = [sample.x, sample.y, 0];
      const last = this.#seen.at(-1);
      if (last && gap(last, seen) < STILL) continue;
      const point = this.place(sample);
      if (!point) continue;
      this.#seen.push(seen);
      this.#line.push(point);
    }
  }

  /** @returns where the sample lies, `null` to leave it out */
  protected abstract place(sample: PointerSample): Vec3 | null;
}

/** On the head it has the head's depth, off it the depth of the last point on the head. */
export class SurfaceStroke extends Stroke {
  #last: Vec3 | null = null;
  #firstOff = Infinity;

  /** How many of its points lie on the head before it first leaves it. */
  get onHead(): number {
    return Math.min(this.#firstOff, this.line.length);
  }

  protected place({ x, y, hit }: PointerSample): Vec3 | null {
    if (hit) {
      this.#last = hit.point;
      return hit.point;
    }
    // Nothing to take a depth from yet: strokes start on the surface.
    if (!this.#last) return null;
    this.#firstOff = Math.min(this.#firstOff, this.line.length);
    return this.view.pointOnScreenPlane(x, y, this.#last);
  }
}

/** The greatest change of depth per way across the screen that a stroke continues with off the surface. */
const STEEPEST = 1;

/** On a supporting surface it lies there; beyond it the depth goes on as in the last segment on it. */
export class SupportStroke extends Stroke {
  /** The last two points on the surface. */
  #before: Vec3 | null = null;
  #last: Vec3 | null = null;

  constructor(
    view: StrokeView,
    private readonly support: SupportSurface,
  ) {
    super(view);
  }

  protected place({ x, y }: PointerSample): Vec3 | null {
    const ray = rayAt(this.view, x, y);
    const met = this.support.meet(ray);
    if (met) {
      this.#before = this.#last;
      this.#last = met;
      return met;
    }
    const last = this.#last ?? nearestOnScreen(this.view, this.support.line, [x, y, 0]);
    if (!last) return null;
    const { position, target } = this.view.camera;
    const ahead = unit(subtract(target, position), [0, 0, -1]);
    const level = this.view.pointOnScreenPlane(x, y, last);
    const deeper = slope(this.#before, this.#last, ahead) * gap(level, last);
    return add(level, scaled(ray.direction, deeper / Math.max(0.1, dot(ray.direction, ahead))));
  }
}

/** Depth gained per way across the screen between two points. */
function slope(a: Vec3 | null, b: Vec3 | null, ahead: Vec3): number {
  if (!a || !b) return 0;
  const by = subtract(b, a);
  const deep = dot(by, ahead);
  const across = gap(by, scaled(ahead, deep));
  return across > 0 ? Math.min(STEEPEST, Math.max(-STEEPEST, deep / across)) : 0;
}

export const onScreen = (view: Pick<ViewportPort, 'project'>, line: Line): Vec3[] =>
  line.map((point) => {
    const { x, y } = view.project(point);
    return [x, y, 0];
  });

/** The point of a line in space that is drawn nearest to a place on the screen. */
export function nearestOnScreen(view: Pick<ViewportPort, 'project'>, line: Line, to: Vec3): Vec3 | undefined {
  const found = nearestOn(onScreen(view, line), to);
  if (!found) return undefined;
  return mix(line[found.segment]!, line[Math.min(found.segment + 1, line.length - 1)]!, found.t);
}
