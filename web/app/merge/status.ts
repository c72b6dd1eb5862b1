// The status bar's sentence in the merge workspace.

import { t } from '../i18n';
import type { State } from '../state';
import type { MergeState } from './state';

/** Reads signals. @param key  the shortcut of a command as it is shown */
export function mergeStatus(state: State, own: MergeState, key: (command: string) => string): string {
  if (state.choosing.value) return t('status.merge.choose');
  const brush = { smaller: key('brush.smaller'), larger: key('brush.larger') };
  if (state.tool.value === 'mark-feature') return t('status.merge.feature', brush);
  if (state.tool.value === 'mark-region') return t('status.merge.region', brush);
  if (own.picked.value) return t('status.merge.picked');
  return (own.step.value?.boundaries.length ?? 0) > 0
    ? t('status.merge.pins')
    : t('status.merge.loops', { paint: key('tool.mark-region') });
}
