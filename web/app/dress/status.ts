// The status bar's sentence in the dress workspace.

import { t } from '../i18n';
import type { State } from '../state';
import type { DressState } from './state';

/** Reads signals. */
export function dressStatus(state: Pick<State, 'choosing'>, own: DressState): string {
  if (state.choosing.value) return t('status.dress.choose');
  const figures = own.figures.value;
  if (!figures) return t('status.dress.waiting');
  return t('status.dress.done');
}
