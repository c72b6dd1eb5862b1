import { LissomError } from '../../core/errors';

export type StrandFormat = 'hair' | 'usda' | 'abc' | 'glb' | 'obj' | 'ply';

export interface StrandWriteOptions {
  /** What one unit of the head measures; every file is written in centimetres, Y up. */
  readonly centimetresPerUnit: number;
  /** Only the strands that lead the others; chosen evenly where the groom names none. */
  readonly guidesOnly?: boolean;
  /** Every how-manieth point is kept; root and tip always are. 1 by default. */
  readonly pointStride?: number;
  /** Share of the strands, from the first on, in (0, 1]: roots are sown so that any first part is even. */
  readonly strandShare?: number;
  /** Whether the head goes along where the format can hold it; true by default. `.hair` never can. */
  readonly withHead?: boolean;
  /** USD only: straight between the points by default, or a cubic through them. */
  readonly curve?: 'linear' | 'catmullRom';
}

/** @throws LissomError `option-out-of-range` */
export function checkOptions(options: StrandWriteOptions): void {
  const { centimetresPerUnit, pointStride = 1, strandShare = 1 } = options;
  if (!(centimetresPerUnit > 0 && centimetresPerUnit < Infinity))
    throw outOfRange('length of a unit in centimetres', 'above 0', centimetresPerUnit);
  if (!(Number.isInteger(pointStride) && pointStride >= 1))
    throw outOfRange('point stride', 'a whole number from 1', pointStride);
  if (!(strandShare > 0 && strandShare <= 1))
    throw outOfRange('share of strands', 'above 0 and at most 1', strandShare);
}

const outOfRange = (what: string, range: string, value: number): LissomError =>
  new LissomError('option-out-of-range', `The ${what} must be ${range}; it is ${value}.`);
