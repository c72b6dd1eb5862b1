// Paints a part of the skin: the selected one, or a new one while none is.

import { PaintTool } from '../paint-tool';
import { PickTool } from '../pick-tool';
import type { Tool } from '../tool';
import { partAt, partVertices } from './edits';
import type { BlendHost, BlendScene } from './host';

export const PART = 'part';

export const paintPart = (host: BlendHost): Tool =>
  new PaintTool<BlendScene>(host, {
    kind: PART,
    scene: () => host.scene(),
    canvas: ({ step, count, selected }) => {
      const part = selected === null ? undefined : step.parts[selected];
      return {
        base: part ? partVertices(part, count) : new Uint32Array(),
        commit: (verb, vertices) => host.commit(verb, part ? selected : null, vertices),
      };
    },
  });

/** A click picks the part under the pointer; a drag turns the view. */
export const pickPart = (host: BlendHost): Tool =>
  new PickTool({
    at: ({ hit }) => {
      const scene = host.scene();
      const part = scene && hit ? partAt(scene.step, hit.vertex) : -1;
      return part < 0 ? null : part;
    },
    pick: (part) => host.pick(part),
  });

/** A click says where a tape is laid around the skin. */
export const girthTool = (host: BlendHost): Tool =>
  new PickTool({
    at: ({ hit }) => (host.scene() && hit ? hit.vertex : null),
    pick: (vertex) => host.measure(vertex),
  });
