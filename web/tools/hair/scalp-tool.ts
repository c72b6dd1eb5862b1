import type { PaintHost, PaintScene } from '../brush-stroke';
import { PaintTool, type PaintVerb } from '../paint-tool';

export interface ScalpScene extends PaintScene {
  /** Source vertices hair grows from now. */
  readonly scalp: Uint32Array;
}

export interface ScalpHost extends PaintHost {
  scalpScene(): ScalpScene | null;
  commitScalp(verb: PaintVerb, scalp: Uint32Array): void;
}

/** Paints where hair grows. */
export const paintScalp = (host: ScalpHost): PaintTool<ScalpScene> =>
  new PaintTool(host, {
    kind: 'scalp',
    scene: () => host.scalpScene(),
    canvas: ({ scalp }) => ({
      base: scalp,
      commit: (verb, vertices) => host.commitScalp(verb, vertices),
    }),
  });
