// The open hair step's strands as files for other programs.

import { LissomError } from '../../core/errors';
import type { Groom } from '../../core/strands';
import { writeStrands } from '../../io/index';
import type { StrandFormat } from '../../io/strands/options';
import type { StrandChoice } from '../api';
import type { Evaluation } from '../evaluation';
import { t } from '../i18n';
import { headHeight } from './steps';

const FORMATS = ['abc', 'usda', 'hair', 'glb', 'obj', 'ply'] as const satisfies readonly StrandFormat[];

export const STRAND_MIME: Readonly<Record<StrandFormat, string>> = {
  abc: 'application/octet-stream',
  usda: 'model/vnd.usda',
  hair: 'application/octet-stream',
  glb: 'model/gltf-binary',
  obj: 'model/obj',
  ply: 'application/octet-stream',
};

export const strandChoices = (): StrandChoice[] =>
  FORMATS.map((format) => ({
    format,
    label: t(`export.strands.${format}`),
    keeps: t(`export.strands.${format}.keeps`),
  }));

/** Centimetres that a unit may be: metre, decimetre, centimetre, millimetre, inch, foot. */
const UNITS = [100, 10, 1, 0.1, 2.54, 30.48];
/** Height of a head with its neck. */
const HEAD = 27;

/** @throws LissomError `nothing-to-export` */
export function strandsFile(
  { step, strands, input }: Evaluation,
  name: string,
  format: StrandFormat,
  guidesOnly: boolean,
): Uint8Array {
  if (step.type !== 'hair' || !strands || strands.offsets.length < 2)
    throw new LissomError('nothing-to-export', t('error.no-hair'));
  const { model } = input;
  const groom: Groom = { name, strands, head: model };
  const centimetresPerUnit = model.unitMetres ? 100 * model.unitMetres : likelyUnit(headHeight(step, model));
  return writeStrands(groom, format, { centimetresPerUnit, guidesOnly });
}

/** The unit in which a head of that height is nearest to a head's size. */
export function likelyUnit(height: number): number {
  const off = (unit: number): number => Math.abs(Math.log((unit * height) / HEAD));
  return height > 0 ? UNITS.reduce((best, unit) => (off(unit) < off(best) ? unit : best)) : 1;
}
