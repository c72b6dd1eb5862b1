// People as scanners and old files bring them: triangles that know nothing of one another, and points without triangles.
// Made of the clean bodies, always the same.

import { BODY, builtIn, matchOf } from './landmarks.mjs';
import { modelOf } from './models.mjs';
import { skinsOf } from './skins.mjs';

/** Metres. */
const SOUP_EDGE = 0.025;
const SOUP_GAP = 0.0001;
const POINT_GAP = 0.0082;
const POINT_NOISE = 0.0006;
/** Of the triangles, how many are missing, and how many are the wrong way round. */
const MISSING = 0.003;
const FLIPPED = 0.02;
/** Points that are tried, for each square metre. */
const TRIES = 80_000;

/** Numbers in [0, 1) that look random: a 32-bit generator by a Weyl sequence and mixing. */
function randomOf(seed) {
  let state = seed;
  return () => {
    state = (state + 0x9e3779b9) | 0;
    let z = Math.imul(state ^ (state >>> 16), 0x85ebca6b);
    z = Math.imul(z ^ (z >>> 13), 0xc2b2ae35);
    return ((z ^ (z >>> 16)) >>> 0) / 2 ** 32;
  };
}

/** About normal, and never farther off than three of the spread: the sum of twelve even ones. */
function noiseOf(random, spread) {
  return () => {
    let sum = -6;
    for (let i = 0; i < 12; i++) sum += random();
    return spread * Math.max(-3, Math.min(3, sum));
  };
}

/** Triangles of a body, each with corners of its own that miss those beside it by a little; a few flipped, a few lost. */
export async function soupOf(name, other) {
  const pair = [name, other];
  const step = matchOf(pair, BODY, { edgeLength: SOUP_EDGE, adapt: 0.7 });
  const { skins } = await skinsOf(builtIn(...pair), step);
  const { positions, faceVertices } = skins[name];
  const random = randomOf(7);
  const noise = noiseOf(random, SOUP_GAP);
  const points = [];
  const triangles = [];
  for (let t = 0; t < faceVertices.length; t += 3) {
    const isMissing = random() < MISSING;
    const isFlipped = random() < FLIPPED;
    if (isMissing) continue;
    const corners = [...faceVertices.subarray(t, t + 3)];
    triangles.push([0, 1, 2].map((k) => points.length + k));
    for (const v of isFlipped ? corners.reverse() : corners)
      points.push([0, 1, 2].map((k) => positions[3 * v + k] + noise()));
  }
  return { points, triangles };
}

/** Places strewn over a body, none nearer to another than a gap, and off the skin by a little noise. */
export function pointsOf(name) {
  const { points: corners, faces } = modelOf(name);
  const random = randomOf(11);
  const noise = noiseOf(random, POINT_NOISE);
  const areas = faces.map((face) => areaOf(...face.map((v) => corners[v])));
  const upTo = [];
  areas.reduce((sum, area, f) => {
    upTo[f] = sum + area;
    return upTo[f];
  }, 0);
  const whole = upTo.at(-1);
  const kept = new Spread(POINT_GAP);
  for (let tried = 0; tried < TRIES * whole; tried++) {
    const [a, b, c] = faces[firstAbove(upTo, random() * whole)].map((v) => corners[v]);
    const root = Math.sqrt(random());
    const share = random();
    kept.offer(a.map((x, k) => (1 - root) * x + root * ((1 - share) * b[k] + share * c[k])));
  }
  return { points: kept.points.map((p) => p.map((x) => x + noise())), triangles: [] };
}

function areaOf(a, b, c) {
  const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
  return Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
}

/** @returns the first place in ascending numbers that has more than `value` */
function firstAbove(ascending, value) {
  let [low, high] = [0, ascending.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ascending[middle] > value) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** Points with a gap between any two, in a grid of cells as wide. */
class Spread {
  points = [];
  #cells = new Map();

  constructor(gap) {
    this.gap = gap;
  }

  offer(point) {
    const cell = point.map((x) => Math.floor(x / this.gap));
    for (let n = 0; n < 27; n++) {
      const near = [n % 3, Math.floor(n / 3) % 3, Math.floor(n / 9)].map((d, k) => cell[k] + d - 1);
      for (const v of this.#cells.get(near.join()) ?? []) {
        const [x, y, z] = this.points[v];
        if (Math.hypot(point[0] - x, point[1] - y, point[2] - z) < this.gap) return;
      }
    }
    const key = cell.join();
    if (!this.#cells.has(key)) this.#cells.set(key, []);
    this.#cells.get(key).push(this.points.length);
    this.points.push(point);
  }
}
