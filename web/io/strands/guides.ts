import { type Strands, strandCount } from '../../core/strands';

/** How many guides stand for a head of hair where nobody says: one in fifty, as engines simulate them. */
export const usualGuideCount = (strands: number): number =>
  Math.min(strands, Math.max(1, Math.min(2000, Math.round(strands / 50))));

/**
 * Strands that lead the others, spread evenly over the roots: the first strand, then again and again the one whose
 * root lies farthest from all chosen (the lowest number where several do).
 *
 * @returns min(count, strands with a root) strand numbers, ascending
 */
export const chooseGuides = (strands: Strands, count: number): Uint32Array =>
  spreadOrder(rootsOf(strands), count).sort();

/** The same in the order of their choice, so that any first part is spread evenly too. `roots`: 3 per strand. */
export function spreadOrder(roots: Float32Array, count: number): Uint32Array {
  const total = roots.length / 3;
  // Squared distance to the chosen; below zero: chosen, or without a root.
  const nearest = new Float64Array(total).fill(Infinity);
  for (let s = 0; s < total; s++)
    if (!Number.isFinite(roots[3 * s]! + roots[3 * s + 1]! + roots[3 * s + 2]!)) nearest[s] = -1;
  const chosen: number[] = [];
  let next = nearest.findIndex((distance) => distance > 0);
  while (next >= 0 && chosen.length < count) {
    chosen.push(next);
    nearest[next] = -1;
    const x = roots[3 * next]!;
    const y = roots[3 * next + 1]!;
    const z = roots[3 * next + 2]!;
    next = -1;
    let farthest = -1;
    for (let s = 0, i = 0; s < total; s++, i += 3) {
      const dx = roots[i]! - x;
      const dy = roots[i + 1]! - y;
      const dz = roots[i + 2]! - z;
      const d = dx * dx + dy * dy + dz * dz;
      let held = nearest[s]!;
      if (d < held) {
        held = d;
        nearest[s] = d;
      }
      if (held <= farthest) continue;
      farthest = held;
      next = s;
    }
  }
  return Uint32Array.from(chosen);
}

export interface ClosestGuides {
  /** 3 per strand, the nearest first: places in `guides`. A repeated place weighs nothing. */
  readonly places: Uint32Array;
  /** 3 per strand, summing to 1: by the inverse square of the distance between the roots. */
  readonly weights: Float32Array;
}

/**
 * The three guides nearest to each strand, root to root.
 *
 * @param guides  strand numbers, one at least
 * @param groups  where given, guides of the strand's own group only, as long as it has any
 */
export function closestGuides(strands: Strands, guides: Uint32Array, groups?: Uint32Array): ClosestGuides {
  const count = strandCount(strands);
  const roots = rootsOf(strands);
  const all = new RootGrid(roots, guides);
  const own = groups ? gridsByGroup(roots, guides, groups) : undefined;
  const places = new Uint32Array(3 * count);
  const weights = new Float32Array(3 * count);
  for (let s = 0; s < count; s++) {
    const found = (own?.get(groups![s]!) ?? all).nearest(
      roots[3 * s]!,
      roots[3 * s + 1]!,
      roots[3 * s + 2]!,
      3,
    );
    weigh(found, places, weights, 3 * s);
  }
  return { places, weights };
}

interface Found {
  readonly place: number;
  readonly squared: number;
}

function weigh(found: readonly Found[], places: Uint32Array, weights: Float32Array, at: number): void {
  const first = found[0];
  places.fill(first?.place ?? 0, at, at + 3);
  if (!first || first.squared === 0 || !Number.isFinite(first.squared)) {
    weights[at] = 1;
    return;
  }
  let sum = 0;
  for (const { squared } of found) sum += first.squared / squared;
  found.forEach(({ place, squared }, k) => {
    places[at + k] = place;
    weights[at + k] = first.squared / squared / sum;
  });
}

function gridsByGroup(roots: Float32Array, guides: Uint32Array, groups: Uint32Array): Map<number, RootGrid> {
  const members = new Map<number, number[]>();
  guides.forEach((s, place) => {
    const group = groups[s]!;
    const list = members.get(group);
    if (list) list.push(place);
    else members.set(group, [place]);
  });
  return new Map(
    [...members].map(([group, list]) => [group, new RootGrid(roots, guides, Uint32Array.from(list))]),
  );
}

/** Guides sorted into cubes by their roots, so that a strand looks at its neighbourhood only. */
export class RootGrid {
  readonly #roots: Float32Array;
  readonly #guides: Uint32Array;
  readonly #cells = new Map<number, number[]>();
  readonly #min: number[];
  readonly #side: number;
  readonly #rings: number;
  readonly #count: number;

  /** @param places  those guides of `guides` that are looked at; all by default */
  constructor(roots: Float32Array, guides: Uint32Array, places?: Uint32Array) {
    this.#roots = roots;
    this.#guides = guides;
    const looked = places ?? guides.map((_, place) => place);
    this.#count = looked.length;
    const min = [Infinity, Infinity, Infinity];
    const max = [-Infinity, -Infinity, -Infinity];
    for (const place of looked)
      for (let k = 0; k < 3; k++) {
        const value = roots[3 * guides[place]! + k]!;
        min[k] = Math.min(min[k]!, value);
        max[k] = Math.max(max[k]!, value);
      }
    const size = Math.max(...min.map((low, k) => max[k]! - low), 0);
    // Roots lie on a surface: about two to a cube when there are as many cubes along the box as this.
    const along = Math.max(1, Math.min(64, Math.round(Math.sqrt(looked.length / 4))));
    this.#min = min;
    this.#side = size > 0 ? size / along : 1;
    this.#rings = along + 1;
    for (const place of looked) {
      const key = this.#key(...this.#cell(3 * guides[place]!, roots));
      const cell = this.#cells.get(key);
      if (cell) cell.push(place);
      else this.#cells.set(key, [place]);
    }
  }

  /** The `most` guides nearest to a point, the nearest first; the lower place where two are as near. */
  nearest(x: number, y: number, z: number, most: number): Found[] {
    const wanted = Math.min(most, this.#count);
    const found: Found[] = [];
    const point = [x, y, z];
    if (!Number.isFinite(x + y + z)) return found;
    // A point outside the box starts from the box's nearest cube.
    const [i, j, k] = this.#cell(0, point).map((c) => Math.max(0, Math.min(this.#rings, c))) as [
      number,
      number,
      number,
    ];
    for (let ring = 0; ring <= this.#rings; ring++) {
      // Cubes beyond this ring are at least this far away.
      const reach = this.#side * (ring - 1);
      if (found.length === wanted && ring > 0 && found[wanted - 1]!.squared < reach * reach) break;
      for (let a = i - ring; a <= i + ring; a++)
        for (let b = j - ring; b <= j + ring; b++) {
          const shell = Math.max(Math.abs(a - i), Math.abs(b - j)) === ring;
          for (let c = k - ring; c <= k + ring; c += shell ? 1 : Math.max(1, 2 * ring))
            for (const place of this.#cells.get(this.#key(a, b, c)) ?? [])
              this.#insert(found, place, point, wanted);
        }
    }
    return found;
  }

  #insert(found: Found[], place: number, [x, y, z]: number[], wanted: number): void {
    const at = 3 * this.#guides[place]!;
    const squared =
      (this.#roots[at]! - x!) ** 2 + (this.#roots[at + 1]! - y!) ** 2 + (this.#roots[at + 2]! - z!) ** 2;
    let rank = found.length;
    while (rank > 0 && isNearer(squared, place, found[rank - 1]!)) rank--;
    if (rank >= wanted) return;
    found.splice(rank, 0, { place, squared });
    if (found.length > wanted) found.pop();
  }

  #cell(at: number, from: ArrayLike<number>): [number, number, number] {
    const index = (k: number) => Math.floor((from[at + k]! - this.#min[k]!) / this.#side);
    return [index(0), index(1), index(2)];
  }

  #key(a: number, b: number, c: number): number {
    return ((a + 128) * 512 + b + 128) * 512 + c + 128;
  }
}

const isNearer = (squared: number, place: number, other: Found): boolean =>
  squared < other.squared || (squared === other.squared && place < other.place);

/** 3 per strand; NaN for a strand without points. */
export function rootsOf({ offsets, points }: Pick<Strands, 'offsets' | 'points'>): Float32Array {
  const count = Math.max(0, offsets.length - 1);
  const roots = new Float32Array(3 * count).fill(NaN);
  for (let s = 0; s < count; s++)
    if (offsets[s + 1]! > offsets[s]!)
      for (let k = 0; k < 3; k++) roots[3 * s + k] = points[3 * offsets[s]! + k]!;
  return roots;
}
