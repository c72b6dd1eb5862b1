// The status bar's sentence: what a click and a drag do now, and which keys matter.

import type { KeymapService } from './api';
import { hairStatus } from './hair/status';
import { t } from './i18n';
import { mergeStatus } from './merge/status';
import type { State } from './state';

/** Reads signals. */
export function statusText(state: State, keymap: KeymapService): string {
  const key = (command: string): string => keymap.hint(command);
  if (!state.model.value) return t('status.no-model', { open: key('file.open') });
  if (state.hair.viewed.value) return t('status.viewed', { back: key('edit.cancel') });
  if (state.workspace.value === 'hair') return hairStatus(state, key);
  if (state.workspace.value === 'merge') return mergeStatus(state, key);
  const brush = { smaller: key('brush.smaller'), larger: key('brush.larger') };
  switch (state.tool.value) {
    case 'select':
      return state.step.value?.handles.length
        ? t('status.select')
        : t('status.select.none', { paint: key('tool.paint-handle') });
    case 'point-handle':
      return t('status.point');
    default:
      return state.brushMode.value === 'erase' ? t('status.erase', brush) : t('status.paint', brush);
  }
}
