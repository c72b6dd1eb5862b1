// All skins in one file: an archive of models that share one list of faces, or one model with the others as morph targets.

import { LissomError } from '../../core/errors';
import { writeGltfMorphs } from '../../io/gltf-morphs';
import { writeModelArchive } from '../../io/model-archive';
import { t } from '../i18n';
import type { ExportGroup } from '../wing';
import type { MatchState } from './state';

/** The order in which the dialog offers them. */
const FORMATS = {
  glb: { label: 'export.match.glb', keeps: 'export.match.glb.keeps', mimeType: 'model/gltf-binary' },
  'obj.zip': { label: 'export.match.obj', keeps: 'export.match.obj.keeps', mimeType: 'application/zip' },
  'ply.zip': { label: 'export.match.ply', keeps: 'export.match.ply.keeps', mimeType: 'application/zip' },
} as const;

export const skinsExport = (own: Pick<MatchState, 'result'>): ExportGroup => ({
  label: t('export.match'),
  besideLabel: t('export.match.one'),
  choices: Object.entries(FORMATS).map(([format, { label, keeps, mimeType }]) => ({
    format,
    label: t(label),
    keeps: t(keeps),
    mimeType,
  })),
  about: t('export.match.about'),
  write(_shown, _name, format) {
    const result = own.result.peek();
    if (!result) throw new LissomError('match-no-skins', t('error.match-no-skins'));
    if (format === 'glb') return writeGltfMorphs(result.models[0]!, result.models.slice(1), 'glb');
    return writeModelArchive(result.models, format === 'obj.zip' ? 'obj' : 'ply');
  },
});
