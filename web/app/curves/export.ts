// The open step's curves as a skeleton for other programs.

import { LissomError } from '../../core/errors';
import { writeSkinnedGltf } from '../../io/gltf-skin';
import { t } from '../i18n';
import type { ExportGroup } from '../wing';
import type { WingParts } from '../wing-parts';

export const skinExport = ({ runner }: Pick<WingParts, 'runner'>): ExportGroup => ({
  label: t('ui.export.skin'),
  besideLabel: t('ui.export.posed'),
  about: t('ui.export.skin.about'),
  choices: [
    {
      format: 'glb',
      label: t('export.skin.glb'),
      keeps: t('export.skin.glb.keeps'),
      mimeType: 'model/gltf-binary',
    },
  ],
  async write({ recipe, step, inputs: [rest] }) {
    if (!rest || step.type !== 'curves' || step.curves.length === 0)
      throw new LissomError('nothing-to-export', t('error.no-curves'));
    return writeSkinnedGltf(rest.model, await runner.ask(recipe, step.id, 'skin', {}), 'glb');
  },
});
