// Strokes on a head as a hand would draw them. Directions are degrees from the middle of the scalp: azimuth from the
// face round by the left ear (+x), elevation upwards.

import { setOf } from '../vertex-set.mjs';
import { along, HeadSurface, slerp, towards, unit } from './head-surface.mjs';

const PLACES = 3;
const round = (point) => point.map((x) => Math.round(x * 10 ** PLACES) / 10 ** PLACES + 0);

/** One head with the moves of a hand on it. Lengths are parts of the head's height. */
export class Hand {
  /** @param head  as `modelOf` gives it */
  constructor(head) {
    this.head = new HeadSurface(head);
    this.size = this.head.height;
  }

  /** A point over the skin. */
  over([azimuth, elevation], lift = 0) {
    return this.overDirection(towards(azimuth, elevation), lift);
  }

  overDirection(direction, lift = 0) {
    const { point } = this.head.at(direction);
    return along(point, unit(direction), lift * this.size);
  }

  /**
   * Over the skin from stop to stop by the shortest ways, `lift` growing from nothing.
   *
   * @param stops  'azimuth,elevation azimuth,elevation …'
   */
  skin(stops, { lift = 0.02, steps = 5 } = {}) {
    const directions = stops.split(' ').map((stop) => towards(...stop.split(',').map(Number)));
    const out = [];
    const spans = directions.length - 1;
    for (let i = 0; i < spans; i++)
      for (let k = i === 0 ? 0 : 1; k <= steps; k++) {
        const t = (i + k / steps) / spans;
        out.push(
          this.overDirection(slerp(directions[i], directions[i + 1], k / steps), lift * Math.min(1, 3 * t)),
        );
      }
    return out;
  }

  /** On from the last point in steps: each `[out, down, forward]` in parts of the head's height. */
  hang(line, steps) {
    const side = Math.abs(line.at(-1)[0]) < 1e-3 ? 0 : Math.sign(line.at(-1)[0]);
    const out = [...line];
    for (const [aside, down, forward] of steps) {
      const [x, y, z] = out.at(-1);
      out.push([x + side * aside * this.size, y - down * this.size, z + forward * this.size]);
    }
    return out;
  }

  stream(line, fade = false) {
    const points = line.map(round);
    return fade ? { points, fade } : { points };
  }

  /**
   * How much shorter hair is cut that grows lower, so that it all ends at one level.
   *
   * @param max  of the hair that is not shortened
   */
  cutAt(level, max) {
    const parts = [0.12, 0.3, 0.48, 0.66, 0.84].map((factor) => ({ factor, chosen: [] }));
    for (const v of this.head.scalp) {
      const fall = (1.15 * (this.head.points[v][1] - level)) / max;
      const part = parts.findLast(({ factor }) => factor <= Math.max(fall, 0.12));
      if (fall < 1) part.chosen.push(v);
    }
    return parts
      .filter(({ chosen }) => chosen.length > 0)
      .map(({ factor, chosen }) => ({ vertices: setOf(chosen), factor }));
  }

  parting(stops, tilt) {
    const points = this.skin(stops, { lift: 0, steps: 4 }).map(round);
    return tilt ? { points, tilt } : { points };
  }

  /** A ring about `centre` across `axis`. */
  ring(centre, axis, radius) {
    const w = unit(axis);
    const u = unit(Math.abs(w[1]) < 0.9 ? [w[2], 0, -w[0]] : [1, 0, 0]);
    const v = [w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]];
    return Array.from({ length: 8 }, (_, i) => {
      const angle = (2 * Math.PI * i) / 8;
      const across = u.map((x, k) => Math.cos(angle) * x + Math.sin(angle) * v[k]);
      return along(centre, across, radius * this.size);
    });
  }

  /** A tail along `spine`, tied at its second point, with its outline on either side: radii along the spine. */
  ponytail(spine, radii, tightness) {
    const axis = spine.map((_, i) => {
      const [a, b] = [spine[Math.max(0, i - 1)], spine[Math.min(i + 1, spine.length - 1)]];
      return unit(b.map((x, k) => x - a[k]));
    });
    const across = axis.map(([x, y, z]) => (Math.abs(x) > 0.9 ? unit([0, z, -y]) : unit([z, 0, -x])));
    const outline = (side) =>
      radii.map((radius, i) => round(along(spine[i + 1], across[i + 1], side * radius * this.size)));
    return {
      spine: spine.map(round),
      section: this.ring(spine[1], axis[1], radii[0]).map(round),
      profiles: [outline(1), outline(-1)],
      ...(tightness !== undefined && { tightness }),
    };
  }
}
