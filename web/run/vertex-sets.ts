import { LissomError } from '../core/errors';
import { hashValue } from '../core/hash';
import { firstOutside, type VertexSet } from '../core/vertex-set';
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
