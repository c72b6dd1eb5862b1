// What the floors above know of hair in the viewport: plain data, model space.

import type { Strands } from '../../core/strands';

export interface HairOptions {
  readonly show: boolean;
  /** `kajiya-kay`: the thesis's pictures; `natural`: two highlights, light through the hair, colour by depth. */
  readonly shading: 'natural' | 'kajiya-kay';
  /** Strands are drawn this much thicker: full count / preview count while few stand for many. At most 3 counts. */
  readonly widthScale: number;
}

/** The strands in a picture. */
export interface HairPort {
  /** Strands in the shown model's space (or alone); null takes them away. Their look comes with them. */
  setHair(strands: Strands | null): void;
  setHairOptions(options: Partial<HairOptions>): void;
  /** The first so many (0..1) are drawn, thicker; null: as fast as the machine allows while moving, all at rest. */
  setStrandShare(share: number | null): void;
}
