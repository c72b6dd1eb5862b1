// The status bar's sentence while lines of the view are in hand.

import { t } from '../../i18n';
import type { State } from '../../state';
import type { ContoursState } from './state';

/** Reads signals. */
export function contoursStatus({ previewing }: Pick<State, 'previewing'>, own: ContoursState): string {
  const problem = own.problem.value;
  if (problem) return t(`status.contours.${problem}`);
  if (previewing.value) return t('status.contours.pulling');
  const { line, part } = own.lit.value;
  if (part === 'start' || part === 'end') return t('status.contours.end');
  if (part === 'ring') return t('status.contours.ring');
  if (line !== null) return t('status.contours.line');
  if (own.hand.value) return t('status.contours.held');
  const lines = own.lines.value;
  if (!lines) return t('status.contours.finding');
  return lines.suggestive.length > 0 ? t('status.contours.pick') : t('status.contours.none');
}
