// The status bar's sentence: what a click and a drag do now, and which keys matter.

import type { KeymapService, WingService } from './api';
import { t } from './i18n';
import type { State } from './state';

/** Reads signals. */
export function statusText(state: State, keymap: KeymapService, { open }: Pick<WingService, 'open'>): string {
  const key = (command: string): string => keymap.hint(command);
  if (!state.model.value) return t('status.no-model', { open: key('file.open') });
  return state.viewing.value?.status(key) ?? open.value?.wing.status(key) ?? '';
}
