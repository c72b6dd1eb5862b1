// The status bar's sentence in the deform workspace.

import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { DeformState } from './state';

/** Reads signals. @param key  the shortcut of a command as it is shown */
export function deformStatus(
  { state, evaluator }: Pick<WingParts, 'state' | 'evaluator'>,
  own: DeformState,
  key: (command: string) => string,
): string {
  if (evaluator.result.value?.moved) return t('status.isolines');
  const brush = { smaller: key('brush.smaller'), larger: key('brush.larger') };
  switch (state.tool.value) {
    case 'select':
      return own.step.value?.handles.length
        ? t('status.select')
        : t('status.select.none', { paint: key('tool.paint-handle') });
    case 'point-handle':
      return t('status.point');
    default:
      return state.brushMode.value === 'erase' ? t('status.erase', brush) : t('status.paint', brush);
  }
}
