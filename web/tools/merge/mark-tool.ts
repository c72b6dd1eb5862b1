import { PaintTool } from '../paint-tool';
import type { Mark, MergeHost, MergeScene } from './host';

/** Paints a mark on the model of one pane. */
export const paintMark = (host: MergeHost, mark: Mark): PaintTool<MergeScene> =>
  new PaintTool(host, {
    kind: mark,
    scene: () => host.scene(),
    canvas: (scene) => ({
      base: scene.mark(mark),
      commit: (verb, vertices) => host.commitMark(mark, verb, vertices),
    }),
  });
