// The status bar's sentence in the curves workspace.

import { t } from '../i18n';
import type { State } from '../state';
import { contoursStatus } from './contours/status';
import type { CurvesState } from './state';

/** Reads signals. @param key  the shortcut of a command as it is shown */
export function curvesStatus(state: State, own: CurvesState, key: (command: string) => string): string {
  if (own.stopped.value) return t('status.curves.stopped');
  if (own.playing.value) return t('status.curves.playing');
  const keys = { draw: key('tool.sketch-curve'), pose: key('tool.pose-curves') };
  switch (state.tool.value) {
    case 'contours':
      return contoursStatus(state, own.contours);
    case 'sketch-curve':
      return own.step.value?.curves.length ? t('status.curves.sketch', keys) : t('status.curves.first');
    case 'link-curves':
      return own.grip.value?.point == null ? t('status.curves.link') : t('status.curves.link-to');
    default:
      if (!own.step.value?.curves.length) return t('status.curves.none', keys);
      if (own.gizmo.value === 'end') return t('status.curves.ends');
      return own.reach.value ? t('status.curves.reach') : t('status.curves.pose');
  }
}
