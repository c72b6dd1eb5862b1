// A low shoe around a foot of the gallery: what lies within a few millimetres of the foot, smoothed over the toes, on a sole.

import { blend } from './distances.mjs';
import { implicitSurface } from './implicit-surface.mjs';
import { modelOf } from './models.mjs';

/** Metres. */
const CELL = 0.0025;
const MARGIN = 0.02;
/** From the skin to the outside of the leather, and of the sole. */
const LEATHER = 0.0055;
const WELT = 0.0085;
const SOLE = 0.012;
/** Of the opening, above the ground: at the heel, and how much lower in front. */
const COLLAR = 0.078;
const DIP = 0.3;

/** Distances on a grid, below 0 inside, and between its corners. */
class Field {
  constructor(low, high, valueAt) {
    this.low = low;
    this.count = low.map((l, k) => Math.ceil((high[k] - l) / CELL) + 1);
    this.values = new Float64Array(this.count[0] * this.count[1] * this.count[2]);
    this.each((at, i, j, k) => {
      this.values[at] = valueAt(...[i, j, k].map((n, axis) => low[axis] + CELL * n));
    });
  }

  each(visit) {
    const [nx, ny, nz] = this.count;
    let at = 0;
    for (let k = 0; k < nz; k++)
      for (let j = 0; j < ny; j++) for (let i = 0; i < nx; i++) visit(at++, i, j, k);
  }

  /** The mean over three corners along each axis, again and again: gaps as wide as toes are apart are closed. */
  smoothed(rounds) {
    for (let round = 0; round < rounds; round++)
      for (const [axis, stride] of [1, this.count[0], this.count[0] * this.count[1]].entries()) {
        const before = this.values.slice();
        this.each((at, ...place) => {
          if (place[axis] === 0 || place[axis] === this.count[axis] - 1) return;
          this.values[at] = (before[at - stride] + before[at] + before[at + stride]) / 3;
        });
      }
    return this;
  }

  at(...point) {
    const place = point.map((x, k) => Math.min(this.count[k] - 1.001, Math.max(0, (x - this.low[k]) / CELL)));
    const corner = place.map(Math.floor);
    const share = place.map((x, k) => x - corner[k]);
    let sum = 0;
    for (let c = 0; c < 8; c++) {
      const step = [c & 1, (c >> 1) & 1, c >> 2];
      const weight = step.reduce((w, s, k) => w * (s ? share[k] : 1 - share[k]), 1);
      const [i, j, k] = corner.map((n, axis) => n + step[axis]);
      sum += weight * this.values[(k * this.count[1] + j) * this.count[0] + i];
    }
    return sum;
  }
}

function normalsOf({ points, faces }) {
  const normals = points.map(() => [0, 0, 0]);
  for (const [a, b, c] of faces) {
    const [u, v] = [b, c].map((corner) => points[corner].map((x, k) => x - points[a][k]));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    for (const corner of [a, b, c]) for (let k = 0; k < 3; k++) normals[corner][k] += normal[k];
  }
  return normals;
}

/** @param name  of the foot */
export function shoeOf(name) {
  const foot = modelOf(name);
  const normals = normalsOf(foot);
  const range = (k, pick) => foot.points.reduce((best, p) => pick(best, p[k]), foot.points[0][k]);
  const ground = range(1, Math.min);
  const low = [0, 1, 2].map((k) => range(k, Math.min) - MARGIN);
  const high = [0, 1, 2].map((k) => range(k, Math.max) + MARGIN);
  high[1] = ground + COLLAR + MARGIN;
  const near = foot.points.flatMap((p, v) => (p[1] < high[1] + MARGIN ? [v] : []));
  const skin = new Field(low, high, (...q) => {
    let [best, nearest] = [Infinity, 0];
    for (const v of near) {
      const [x, y, z] = foot.points[v];
      const far = (q[0] - x) ** 2 + (q[1] - y) ** 2 + (q[2] - z) ** 2;
      if (far < best) [best, nearest] = [far, v];
    }
    const out = q.reduce((sum, x, k) => sum + (x - foot.points[nearest][k]) * normals[nearest][k], 0);
    return Math.sign(out) * Math.sqrt(best);
  }).smoothed(3);
  /** How far beside the tread, seen from above. */
  const tread = (x, z) => {
    let least = Infinity;
    for (let y = ground; y < ground + 0.03; y += 2 * CELL) least = Math.min(least, skin.at(x, y, z));
    return least;
  };
  const length = high[2] - low[2];
  return implicitSurface({
    low,
    high,
    cell: 2 * CELL,
    opening: (_x, y, z) => {
      const share = (z - low[2]) / length;
      const end = ground + COLLAR * (1 - DIP * share);
      return y > ground + 0.045 ? end : undefined;
    },
    inside: (x, y, z) => {
      // Its edges are rounded: sharp ones fray on a grid.
      const sole = -blend(0.006, WELT - tread(x, z), y - ground + SOLE - MARGIN / 4, ground + 0.006 - y);
      return blend(0.006, skin.at(x, y, z) - LEATHER, sole);
    },
  });
}
