// What the sizes of hair are measured by.

import type { Model } from '../../core/model';
import type { HairStep } from '../../recipe/recipe';
import { scalpOf } from '../../run/steps/hair/scalp';

/** A body is many scalps high, a head about one and a third (as the kernel reckons, hair_volume.cpp). */
const MOST_SCALPS = 2.5;
const HEAD_IN_SCALPS = 1.35;

const heights = new WeakMap<Model, { readonly scalp: HairStep['scalp']; readonly height: number }>();

/** What the sizes of hair are measured by: the head's height in model units, found from its scalp on a body. */
export function headHeight(step: Pick<HairStep, 'scalp'>, model: Model): number {
  const known = heights.get(model);
  if (known && known.scalp === step.scalp) return known.height;
  const all = extent(model, allVertices(model));
  const scalp = Math.max(...extent(model, scalpOf(step, model)));
  const tall = all[model.upAxis === 'z' ? 2 : 1];
  const height = scalp > 0 && tall > MOST_SCALPS * scalp ? HEAD_IN_SCALPS * scalp : tall;
  heights.set(model, { scalp: step.scalp, height });
  return height;
}

function* allVertices({ positions }: Model): Iterable<number> {
  for (let v = 0; v < positions.length / 3; v++) yield v;
}

function extent({ positions }: Model, vertices: Iterable<number>): [number, number, number] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const v of vertices)
    for (let k = 0; k < 3; k++) {
      const x = positions[3 * v + k]!;
      if (!Number.isFinite(x)) continue;
      low[k] = Math.min(low[k]!, x);
      high[k] = Math.max(high[k]!, x);
    }
  return [0, 1, 2].map((k) => Math.max(0, high[k]! - low[k]!)) as [number, number, number];
}
