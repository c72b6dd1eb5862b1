// The open hair step's strands as files for other programs.

import { LissomError } from '../../core/errors';
import { groomFile } from '../../io/strands/groom-file';
import type { StrandFormat } from '../../io/strands/options';
import type { StrandChoice } from '../api';
import type { Evaluation } from '../evaluation';
import { t } from '../i18n';

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

/** @throws LissomError `nothing-to-export` */
export function strandsFile(
  { step, strands, input }: Evaluation,
  name: string,
  format: StrandFormat,
  guidesOnly: boolean,
): Uint8Array {
  if (step.type !== 'hair' || !strands || strands.offsets.length < 2)
    throw new LissomError('nothing-to-export', t('error.no-hair'));
  return groomFile(name, strands, input.model, format, guidesOnly);
}
