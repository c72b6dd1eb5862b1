// What the brush paints in a deform step.

import { fromIndices, toIndices } from '../../core/vertex-set';
import { PaintTool } from '../paint-tool';
import { setHandleVertices } from './edits';
import type { DeformHost, DeformScene } from './host';

/** The region of interest. Painting while it is everything starts it anew; emptied, it stays empty. */
export const paintRoi = (host: DeformHost): PaintTool<DeformScene> =>
  new PaintTool(host, {
    kind: 'roi',
    scene: () => host.scene(),
    canvas: ({ step, selected, rest }, _, erase) => ({
      base: step.roi === 'all' && !erase ? new Uint32Array() : toIndices(step.roi, rest.length / 3),
      commit: (verb, vertices) =>
        host.commit(`${verb}-roi`, {
          step: { ...step, roi: fromIndices(vertices, rest.length / 3) },
          selected,
        }),
    }),
  });

/** A stroke that begins on a handle extends or erases that one (the selected one first); elsewhere it makes a new one. */
export const paintHandle = (host: DeformHost): PaintTool<DeformScene> =>
  new PaintTool(host, {
    kind: 'handle',
    scene: () => host.scene(),
    canvas: (scene, first) => {
      const { step, rest } = scene;
      const index = handleUnder(scene, first);
      const handle = index === null ? undefined : step.handles[index];
      return {
        base: handle ? toIndices(handle.vertices, rest.length / 3) : new Uint32Array(),
        commit: (verb, vertices) =>
          host.commit(`${verb}-handle`, setHandleVertices(scene, index, vertices, host.newName(step))),
      };
    },
  });

function handleUnder({ step, selected, rest }: DeformScene, touched: ReadonlySet<number>): number | null {
  const order = step.handles.map((_, i) => i);
  if (selected !== null) order.unshift(selected);
  const found = order.find((i) => {
    const handle = step.handles[i];
    if (handle?.kind !== 'region' || handle.hidden) return false;
    return toIndices(handle.vertices, rest.length / 3).some((v) => touched.has(v));
  });
  return found ?? null;
}
