// Vertex sets of a step as tinted regions on its model, without doing twice what has not changed.

import { toIndices, type VertexSet } from '../core/vertex-set';
import type { ModelResult } from '../run/types';
import type { RegionPaint, ViewportPort } from '../view/types';

/** A drag moves vertices without changing what is marked: tints that are the same need no new upload. */
export class PaintedRegions {
  #on: object | null = null;
  #regions: readonly RegionPaint[] = [];

  constructor(private readonly viewport: Pick<ViewportPort, 'setRegions'>) {}

  /** @param on  the model that is marked: another one is marked anew */
  show({ opened }: Pick<ModelResult, 'opened'>, regions: readonly RegionPaint[]): void {
    if (this.#on === opened && sameRegions(this.#regions, regions)) return;
    this.#on = opened;
    this.#regions = regions;
    this.viewport.setRegions(regions);
  }

  clear(): void {
    if (this.#on) this.viewport.setRegions([]);
    this.#on = null;
    this.#regions = [];
  }
}

const vertexLists = new WeakMap<object, { readonly count: number; readonly list: Uint32Array }>();

/**
 * Recipes never change in place, so a set is unpacked once; unpacked again it is the same list. Not for another count:
 * a document just opened may be asked about while the smaller model of the one before is still on screen.
 */
export function listed(set: VertexSet, count: number): Uint32Array {
  if (typeof set === 'string') return toIndices(set, count);
  const known = vertexLists.get(set);
  if (known?.count === count) return known.list;
  const list = toIndices(set, count);
  vertexLists.set(set, { count, list });
  return list;
}

const sameRegions = (a: readonly RegionPaint[], b: readonly RegionPaint[]): boolean =>
  a.length === b.length &&
  a.every((region, i) => {
    const other = b[i]!;
    return (
      region.id === other.id &&
      region.tint === other.tint &&
      region.vertices === other.vertices &&
      region.visible === other.visible &&
      region.selected === other.selected
    );
  });
