import { LissomError } from '../core/errors';
import { hashValue } from '../core/hash';
import { firstOutside, sizeOf, type VertexSet } from '../core/vertex-set';
import type { InputShape } from './steps/step-runner';

const keys = new WeakMap<object, string>();

/** Hash of a vertex set as it is written. Recipes and models are immutable, so a set is hashed once, not on every drag. */
export function vertexSetKey(set: VertexSet | Uint32Array): string {
  if (set === 'all') return set;
  let key = keys.get(set);
  if (key === undefined) {
    key = hashValue(set instanceof Uint32Array ? [...set] : set);
    keys.set(set, key);
  }
  return key;
}

/** @throws LissomError `index-out-of-range` */
export function checkVertices(set: VertexSet, path: string, input: InputShape): void {
  const outside = firstOutside(set, input.vertices);
  if (outside === undefined) return;
  throw new LissomError(
    'index-out-of-range',
    `${path}: vertex ${outside} is out of range; ${JSON.stringify(input.name)} has ` +
      `${input.vertices} vertices, numbered 0 to ${input.vertices - 1}.`,
  );
}

/**
 * For sets that may share no vertex: together they name no more than there are. Counted before any is expanded, so that
 * a thousand handles over all of a model cost nothing; which vertex two of them share is for the kernel to say.
 *
 * @throws LissomError `handle-overlap`
 */
export function checkApart(sets: readonly VertexSet[], path: string, input: InputShape): void {
  // Most sets are small: what is written of them already says so, and this is asked on every drag.
  if (sum(sets, written) <= input.vertices) return;
  const named = sum(sets, (set) => sizeOf(set, input.vertices));
  if (named <= input.vertices) return;
  throw new LissomError(
    'handle-overlap',
    `${path}: the handles name ${named} vertices together, but ${JSON.stringify(input.name)} has ` +
      `${input.vertices}; give each vertex to one handle only.`,
  );
}

const written = (set: VertexSet): number => {
  if (set === 'all') return Number.POSITIVE_INFINITY;
  return 'ranges' in set ? sum(set.ranges, ([first, last]) => last - first + 1) : set.length;
};

const sum = <T>(items: readonly T[], value: (item: T) => number): number =>
  items.reduce((held, item) => held + value(item), 0);
