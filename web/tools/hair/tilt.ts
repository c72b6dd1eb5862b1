// Hint strokes beside a parting: how the hair leans along it (Fu 4.5, Fig 4.4).

import { roundTo } from '../../core/decimal';
import type { PointerSample, Vec3 } from '../../view/types';
import { cross, dot, scaled, subtract, unit } from '../geometry';
import { arcAt, type Line, lengthOf, nearestOn } from '../stroke/polyline';
import { SurfaceStroke } from '../stroke/stroke';
import { replacePrimitive } from './edits';
import type { HairEdit, HairHost, HairScene } from './host';
import { SHORTEST } from './measures';
import { type Parting, primitiveAt } from './style';

/** Further over and the two sides would run along the parting instead of away from it. */
const MOST = 75;

/**
 * The lean of a parting whose hair runs along `direction` at `at`.
 *
 * The angle there is the one between the level across the parting and the direction, about the skin's
 * normal, the two sides being turned alike; between the ends it is interpolated, and of the ends the nearer
 * one gives way.
 */
export function tiltedBy(
  { points, tilt }: Pick<Parting, 'points' | 'tilt'>,
  at: Vec3,
  direction: Vec3,
  normal: Vec3,
): [number, number] {
  const found = nearestOn(points, at);
  if (!found) return tilt;
  const y = unit(normal);
  const along = subtract(points[Math.min(found.segment + 1, points.length - 1)]!, points[found.segment]!);
  const z = unit(subtract(along, scaled(y, dot(along, y))));
  const x = cross(y, z);
  const flat = subtract(direction, scaled(y, dot(direction, y)));
  const away = dot(flat, x) < 0 ? scaled(flat, -1) : flat;
  const angle = (Math.atan2(dot(cross(x, away), y), dot(x, away)) * 180) / Math.PI;
  if (!Number.isFinite(angle)) return tilt;
  const t = Math.min(1, Math.max(0, arcAt(points, found) / lengthOf(points)));
  const bounded = (degrees: number) => roundTo(Math.min(MOST, Math.max(-MOST, degrees)), 0);
  const [a, b] = tilt;
  return t < 0.5 ? [bounded((angle - t * b) / (1 - t)), b] : [a, bounded((angle - (1 - t) * a) / t)];
}

/** One hint stroke that sets a parting's lean. */
export class TiltGesture {
  readonly #stroke: SurfaceStroke;
  readonly #start: Vec3;
  readonly #normal: Vec3;

  constructor(
    private readonly host: HairHost,
    private readonly scene: HairScene,
    private readonly index: number,
    sample: PointerSample,
  ) {
    this.#stroke = new SurfaceStroke(host.view);
    this.#start = sample.hit!.point;
    this.#normal = sample.hit!.normal;
    this.#stroke.extend([sample]);
  }

  move(samples: readonly PointerSample[]): void {
    this.#stroke.extend(samples);
    this.host.showStroke({ line: this.#stroke.line, kind: 'hint' });
    const edit = this.#edit(this.#stroke.line);
    if (edit) this.host.preview(edit);
  }

  finish(sample: PointerSample): void {
    this.#stroke.extend([sample]);
    this.host.showStroke(null);
    const edit = this.#edit(this.#stroke.line);
    if (edit) this.host.commit('tilt', edit);
    else this.host.cancel();
  }

  #edit(line: Line): HairEdit | null {
    const primitive = primitiveAt(this.scene.step, this.index);
    const by = subtract(line.at(-1) ?? this.#start, this.#start);
    if (primitive?.kind !== 'parting' || lengthOf([[0, 0, 0], by]) < SHORTEST * this.scene.height)
      return null;
    const tilt = tiltedBy(primitive.item, this.#start, by, this.#normal);
    return replacePrimitive(this.scene, this.index, { kind: 'parting', item: { ...primitive.item, tilt } });
  }
}
