// The open hair step's strands as files for other programs.

import { LissomError } from '../../core/errors';
import { groomFile } from '../../io/strands/groom-file';
import type { StrandFormat } from '../../io/strands/options';
import { t } from '../i18n';
import type { ExportGroup } from '../wing';

const FORMATS = ['abc', 'usda', 'hair', 'glb', 'obj', 'ply'] as const satisfies readonly StrandFormat[];

const MIME: Readonly<Record<StrandFormat, string>> = {
  abc: 'application/octet-stream',
  usda: 'model/vnd.usda',
  hair: 'application/octet-stream',
  glb: 'model/gltf-binary',
  obj: 'model/obj',
  ply: 'application/octet-stream',
};

/** In centimetres; the option writes the guides alone. */
export const strandsExport = (): ExportGroup => ({
  label: t('ui.export.strands'),
  besideLabel: t('ui.export.head'),
  about: t('ui.export.strands.about'),
  option: t('ui.export.guides'),
  choices: FORMATS.map((format) => ({
    format,
    label: t(`export.strands.${format}`),
    keeps: t(`export.strands.${format}.keeps`),
    mimeType: MIME[format],
  })),
  write({ strands, shown }, name, format, guidesOnly) {
    if (!strands || strands.offsets.length < 2)
      throw new LissomError('nothing-to-export', t('error.no-hair'));
    return groomFile(name, strands, shown.model, format as StrandFormat, guidesOnly);
  },
});
