// What a hair step grew, as a file for other programs: the same for the app and the command line.

import type { Model } from '../../core/model';
import type { Strands } from '../../core/strands';
import { writeStrands } from './formats';
import type { StrandFormat } from './options';

/** Centimetres that a unit may be: metre, decimetre, centimetre, millimetre, inch, foot. */
const UNITS = [100, 10, 1, 0.1, 2.54, 30.48];
/** How far apart, in centimetres, the outermost roots of a full scalp lie. */
const SCALP = 20;

/**
 * Hair with the head it grows on, in centimetres.
 *
 * @throws LissomError `nothing-to-export`
 */
export function groomFile(
  name: string,
  strands: Strands,
  head: Model,
  format: StrandFormat,
  guidesOnly = false,
): Uint8Array {
  const centimetresPerUnit = head.unitMetres ? 100 * head.unitMetres : likelyUnit(rootSpan(strands));
  return writeStrands({ name, strands, head }, format, { centimetresPerUnit, guidesOnly });
}

/** The unit in which a scalp of that span is nearest to a scalp's size; for a file that does not say. */
export function likelyUnit(span: number): number {
  const off = (unit: number): number => Math.abs(Math.log((unit * span) / SCALP));
  return span > 0 ? UNITS.reduce((best, unit) => (off(unit) < off(best) ? unit : best)) : 1;
}

/** Longest side of the box round the roots. */
function rootSpan({ offsets, points }: Strands): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let strand = 0; strand + 1 < offsets.length; strand++)
    for (let d = 0; d < 3; d++) {
      const x = points[3 * offsets[strand]! + d]!;
      low[d] = Math.min(low[d]!, x);
      high[d] = Math.max(high[d]!, x);
    }
  return Math.max(0, ...high.map((top, d) => top - low[d]!));
}
