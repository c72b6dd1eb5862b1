import { cross } from '../../core/cross';
import type { Curves } from './curves';
import { curveCount } from './curves';
import { RootGrid, rootsOf, spreadOrder } from './guides';

/** Flat ribbons that stand for many strands each: what games draw instead of hair. */
export interface Cards {
  readonly count: number;
  /** Points along a card; two vertices each, left and right of the middle. */
  readonly rows: number;
  /** 3 per vertex, row by row. */
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** 4 per vertex: the direction of growing u, and the sign of the third axis. */
  readonly tangents: Float32Array;
  /** 2 per vertex: u across in [0, 1], v from root (0) to tip (1). */
  readonly uvs: Float32Array;
  /** Linear red, green, blue per vertex. */
  readonly colors: Float32Array;
}

/** How finely cards stand for the hair. */
interface CardLevel {
  /** Cards at most, and strands a card stands for at least. */
  readonly most: number;
  readonly strandsPerCard: number;
  /** Of the points along a strand, every how-manieth makes a row. */
  readonly stride: number;
}

/** Points along a strand that bundles are made by: twelve parts, which 1, 2 and 4 divide. */
const SAMPLES = 13;

/** From near to far: at most 36,000, 6,000 and 900 triangles. */
const LEVELS: readonly CardLevel[] = [
  { most: 1500, strandsPerCard: 40, stride: 1 },
  { most: 500, strandsPerCard: 120, stride: 2 },
  { most: 150, strandsPerCard: 400, stride: 4 },
];

/** Leaders whose roots are nearest are compared in shape; the best takes the strand. */
const CANDIDATES = 6;

/**
 * Levels of detail, the finest first: strands gathered around evenly spread leaders, each bundle replaced by a card
 * through its middle.
 */
export function makeCards(curves: Curves): Cards[] {
  const total = curveCount(curves);
  const samples = resample(curves, SAMPLES);
  const roots = rootsOf(curves);
  const counts = LEVELS.map(({ most, strandsPerCard }) =>
    Math.max(1, Math.min(most, Math.round(total / strandsPerCard))),
  );
  const order = spreadOrder(roots, counts[0]!);
  const middle = centreOf(samples);
  return LEVELS.map(({ stride }, level) => {
    const leaders = order.slice(0, counts[level]);
    const owner = assign(roots, samples, leaders);
    const members: number[][] = Array.from(leaders, () => []);
    for (let s = 0; s < total; s++) members[owner[s]!]!.push(s);
    const cards = emptyCards(leaders.length, (SAMPLES - 1) / stride + 1);
    members.forEach((strands, card) => {
      putCard(cards, card, strands, samples, curves, middle);
    });
    return cards;
  });
}

const emptyCards = (count: number, rows: number): Cards => ({
  count,
  rows,
  positions: new Float32Array(6 * rows * count),
  normals: new Float32Array(6 * rows * count),
  tangents: new Float32Array(8 * rows * count),
  uvs: new Float32Array(4 * rows * count),
  colors: new Float32Array(6 * rows * count),
});

/** `rows` points along each strand, evenly by length. */
function resample({ offsets, points }: Curves, rows: number): Float32Array {
  const count = offsets.length - 1;
  const out = new Float32Array(3 * rows * count);
  for (let s = 0; s < count; s++) {
    const [first, last] = [offsets[s]!, offsets[s + 1]! - 1];
    let whole = 0;
    for (let p = first; p < last; p++) whole += distance(points, p, p + 1);
    let [p, before, step] = [first, 0, distance(points, first, first + 1)];
    for (let r = 0; r < rows; r++) {
      const wanted = (whole * r) / (rows - 1);
      while (p < last - 1 && before + step < wanted) {
        before += step;
        p++;
        step = distance(points, p, p + 1);
      }
      const t = step > 0 ? Math.min(1, (wanted - before) / step) : 0;
      for (let k = 0; k < 3; k++) {
        const a = points[3 * p + k]!;
        out[3 * (rows * s + r) + k] = a + t * (points[3 * p + 3 + k]! - a);
      }
    }
  }
  return out;
}

function distance(points: Float32Array, p: number, q: number): number {
  const dx = points[3 * p]! - points[3 * q]!;
  const dy = points[3 * p + 1]! - points[3 * q + 1]!;
  const dz = points[3 * p + 2]! - points[3 * q + 2]!;
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}

/** The place of its leader for each strand: of those rooted nearest, the one that runs most alike. */
function assign(roots: Float32Array, samples: Float32Array, leaders: Uint32Array): Uint32Array {
  const grid = new RootGrid(roots, leaders);
  const size = 3 * SAMPLES;
  return Uint32Array.from({ length: roots.length / 3 }, (_, s) => {
    let best = 0;
    let least = Infinity;
    for (const { place } of grid.nearest(roots[3 * s]!, roots[3 * s + 1]!, roots[3 * s + 2]!, CANDIDATES)) {
      const leader = leaders[place]!;
      let apart = 0;
      for (let i = 0; i < size; i++) {
        const gap = samples[size * s + i]! - samples[size * leader + i]!;
        apart += gap * gap;
      }
      if (apart >= least) continue;
      least = apart;
      best = place;
    }
    return best;
  });
}

function centreOf(samples: Float32Array): number[] {
  const sum = [0, 0, 0];
  for (let i = 0; i < samples.length; i++) sum[i % 3]! += samples[i]!;
  return sum.map((c) => (3 * c) / samples.length);
}

/** The card of one bundle: through its middle, as wide as it spreads, facing away from the head's inside. */
function putCard(
  cards: Cards,
  card: number,
  strands: readonly number[],
  samples: Float32Array,
  curves: Curves,
  centre: readonly number[],
): void {
  const { rows } = cards;
  const stride = (SAMPLES - 1) / (rows - 1);
  const line = meanLine(strands, samples, rows);
  const sides = sidesOf(line, rows, centre);
  const color = [0, 1, 2].map(
    (k) => strands.reduce((sum, s) => sum + curves.colors[3 * s + k]!, 0) / strands.length,
  );
  const hair = strands.reduce((most, s) => Math.max(most, curves.widths[curves.offsets[s]!]!), 0);
  for (let r = 0; r < rows; r++) {
    const side = sides[r]!;
    const along = tangentAt(line, r, rows);
    const normal = cross(side, along);
    // Strands spread evenly over a width w lie w/√12 from its middle, root mean square.
    let spread = 0;
    for (const s of strands) {
      let off = 0;
      for (let k = 0; k < 3; k++)
        off += (samples[3 * (SAMPLES * s + stride * r) + k]! - line[3 * r + k]!) * side[k]!;
      spread += off * off;
    }
    const half = Math.sqrt((3 * spread) / strands.length) + hair;
    for (const right of [0, 1]) {
      const v = 2 * (rows * card + r) + right;
      for (let k = 0; k < 3; k++) {
        cards.positions[3 * v + k] = line[3 * r + k]! + (right ? half : -half) * side[k]!;
        cards.normals[3 * v + k] = normal[k]!;
        cards.tangents[4 * v + k] = side[k]!;
        cards.colors[3 * v + k] = color[k]!;
      }
      // v grows downwards in glTF's pictures, so the third axis, up in them, points to the root.
      cards.tangents[4 * v + 3] = -1;
      cards.uvs[2 * v] = right;
      cards.uvs[2 * v + 1] = r / (rows - 1);
    }
  }
}

function meanLine(strands: readonly number[], samples: Float32Array, rows: number): Float64Array {
  const stride = (SAMPLES - 1) / (rows - 1);
  const line = new Float64Array(3 * rows);
  for (const s of strands)
    for (let r = 0; r < rows; r++)
      for (let k = 0; k < 3; k++)
        line[3 * r + k]! += samples[3 * (SAMPLES * s + stride * r) + k]! / strands.length;
  return line;
}

type Vec = readonly [number, number, number];

/**
 * The direction across the card in every row: along × outwards. Where hair stands straight off the head that is
 * nothing, so every row takes half of the card's sum as well.
 */
function sidesOf(line: Float64Array, rows: number, centre: readonly number[]): Vec[] {
  const own = Array.from({ length: rows }, (_, r) => {
    const outwards = unit([0, 1, 2].map((k) => line[3 * r + k]! - centre[k]!) as unknown as Vec, [0, 1, 0]);
    return cross(tangentAt(line, r, rows), outwards);
  });
  const sum = [0, 1, 2].map((k) => own.reduce((held, side) => held + side[k]!, 0)) as unknown as Vec;
  return own.map((side, r) => {
    const along = tangentAt(line, r, rows);
    const wanted = [0, 1, 2].map((k) => side[k]! + sum[k]! / 2) as unknown as Vec;
    const lean = dot(wanted, along);
    const level = [0, 1, 2].map((k) => wanted[k]! - lean * along[k]!) as unknown as Vec;
    return unit(level, anyAcross(along));
  });
}

function tangentAt(line: Float64Array, r: number, rows: number): Vec {
  const [a, b] = [3 * Math.max(0, r - 1), 3 * Math.min(rows - 1, r + 1)];
  return unit([line[b]! - line[a]!, line[b + 1]! - line[a + 1]!, line[b + 2]! - line[a + 2]!], [0, -1, 0]);
}

const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** The vector at length one; `otherwise` where it has no direction to speak of. */
function unit(v: Vec, otherwise: Vec): Vec {
  const length = Math.sqrt(dot(v, v));
  return length > 1e-6 ? [v[0] / length, v[1] / length, v[2] / length] : otherwise;
}

const anyAcross = (along: Vec): Vec =>
  unit(cross(along, Math.abs(along[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]), [1, 0, 0]);
