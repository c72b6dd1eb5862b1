// Joints brought to where they belong in another body.

import { type Affine, IDENTITY, multiply } from '../core/affine';
import { cross } from '../core/cross';
import { orientationBetween } from '../core/orientation';
import { rotated } from '../core/quaternion';
import type { Rig } from '../core/rig';

/**
 * The rig of one skin on another of the same triangles: each joint goes the way of what it moves, by the similarity that takes its
 * vertices closest to where they are on the other skin (least squares; each counts by its weight and the area around it). A joint
 * whose vertices leave that open goes with the one it hangs from, one that hangs from none with the whole body.
 *
 * @param from  of the skin that has it, 3 per vertex
 */
export function carriedRig(rig: Rig, triangles: Uint32Array, from: Float64Array, to: Float64Array): Rig {
  const areas = vertexAreas(triangles, from);
  const { influences, indices, weights } = rig;
  const fits = rig.joints.map(() => new Fit());
  const whole = new Fit();
  const everyShare = (take: (fit: Fit, v: number, weight: number) => void) => {
    for (const [v, area] of areas.entries()) {
      if (!(area > 0)) continue;
      take(whole, v, area);
      for (let k = influences * v; k < influences * (v + 1); k++)
        if (weights[k]! > 0) take(fits[indices[k]!]!, v, area * weights[k]!);
    }
  };
  everyShare((fit, v, weight) => fit.middle(from, to, v, weight));
  everyShare((fit, v, weight) => fit.spread(from, to, v, weight));
  const body = whole.similarity() ?? IDENTITY;
  const own = fits.map((fit) => fit.similarity());
  const goesBy = (joint: number): Affine => {
    const open: number[] = [];
    let at = joint;
    for (; at >= 0 && !own[at]; at = rig.joints[at]!.parent) open.push(at);
    const found = own[at] ?? body;
    for (const each of open) own[each] = found;
    return found;
  };
  const joints = rig.joints.map((joint, at) => ({ ...joint, bind: multiply(goesBy(at), joint.bind) }));
  return { ...rig, joints };
}

/** Where points as good as on a line leave the turn about it open: the share by which the best turn must be better than the next. */
const OPEN = 1e-6;

/** The similarity between weighted points and where they go (Horn 1987), gathered in two rounds: their middles, then about them. */
class Fit {
  #weight = 0;
  readonly #from = new Float64Array(3);
  readonly #to = new Float64Array(3);
  readonly #moments = new Float64Array(9);
  #size = 0;

  middle(from: Float64Array, to: Float64Array, v: number, weight: number): void {
    this.#weight += weight;
    for (let k = 0; k < 3; k++) {
      this.#from[k]! += weight * from[3 * v + k]!;
      this.#to[k]! += weight * to[3 * v + k]!;
    }
  }

  spread(from: Float64Array, to: Float64Array, v: number, weight: number): void {
    const total = this.#weight;
    for (let j = 0; j < 3; j++) {
      const p = from[3 * v + j]! - this.#from[j]! / total;
      this.#size += weight * p * p;
      for (let k = 0; k < 3; k++)
        this.#moments[3 * j + k]! += weight * p * (to[3 * v + k]! - this.#to[k]! / total);
    }
  }

  /** @returns `undefined` where the points leave it open */
  similarity(): Affine | undefined {
    const { rotation, largest, next } = orientationBetween(this.#moments);
    const scale = largest / this.#size;
    if (!(scale > 0 && Number.isFinite(scale) && largest - next > OPEN * largest)) return undefined;
    const column = (x: number, y: number, z: number) =>
      rotated(rotation, [x, y, z]).map((value) => scale * value);
    const columns = [column(1, 0, 0), column(0, 1, 0), column(0, 0, 1)];
    const place = [0, 1, 2].map((row) => {
      let at = this.#to[row]!;
      for (let k = 0; k < 3; k++) at -= columns[k]![row]! * this.#from[k]!;
      return at / this.#weight;
    });
    return [...columns.flatMap((each) => [...each, 0]), ...place, 1];
  }
}

/** A third of the triangles around each vertex. */
function vertexAreas(triangles: Uint32Array, positions: Float64Array): Float64Array {
  const areas = new Float64Array(positions.length / 3);
  for (let first = 0; first < triangles.length; first += 3) {
    const [a, b, c] = [triangles[first]!, triangles[first + 1]!, triangles[first + 2]!];
    const side = (v: number, k: number) => positions[3 * v + k]! - positions[3 * a + k]!;
    const to = (v: number) => [side(v, 0), side(v, 1), side(v, 2)] as const;
    const third = Math.hypot(...cross(to(b), to(c))) / 6;
    for (const v of [a, b, c]) areas[v]! += third;
  }
  return areas;
}
