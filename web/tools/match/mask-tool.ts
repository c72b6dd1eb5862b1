import { PaintTool } from '../paint-tool';
import type { MatchHost, MatchScene } from './host';

/** What of a model is ignored: hair, a stand, a hole. */
export const maskTool = (host: MatchHost): PaintTool<MatchScene> =>
  new PaintTool(host, {
    kind: 'mask',
    scene: () => host.scene(),
    canvas: ({ ignored }) => ({
      base: ignored,
      commit: (verb, vertices) => host.commitMask(verb, vertices),
    }),
  });
