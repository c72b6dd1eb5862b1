// Joints of the source: whose each vertex of its skin is.

import { keepLargest, type Rig } from '../../../core/rig';
import type { SurfacePlaces } from '../../../kernel/contract/wear';
import type { ModelResult } from '../../types';

/** The rig of a model where its skin's vertices lie on it: weights mixed by those of each place, the largest kept. */
export function readRig({ model, opened }: ModelResult, places: SurfacePlaces): Rig | undefined {
  const { rig } = model;
  if (!rig) return undefined;
  const { influences } = rig;
  const count = places.triangles.length;
  const indices = new Uint16Array(influences * count);
  const weights = new Float32Array(influences * count);
  for (let v = 0; v < count; v++) {
    const shareOf = new Map<number, number>();
    for (let corner = 0; corner < 3; corner++) {
      const first = influences * opened.triangles[3 * places.triangles[v]! + corner]!;
      const part = places.weights[3 * v + corner]!;
      for (let k = first; k < first + influences; k++) {
        const share = part * rig.weights[k]!;
        if (share > 0) shareOf.set(rig.indices[k]!, (shareOf.get(rig.indices[k]!) ?? 0) + share);
      }
    }
    const byJoint = [...shareOf].sort(([i], [j]) => i - j);
    keepLargest({ influences, indices, weights }, v, byJoint);
  }
  return { ...rig, indices, weights };
}
