// The status bar's sentence in the transfer workspace.

import { t } from '../i18n';
import type { State } from '../state';
import type { TransferActions } from './actions';

/** Reads signals. @param key  the shortcut of a command as it is shown */
export function transferStatus(
  state: State,
  actions: Pick<TransferActions, 'pose' | 'handleName' | 'isThrough' | 'open'>,
  key: (command: string) => string,
): string {
  if (state.choosing.value) return t('status.transfer.choose');
  if (actions.isThrough()) return t('status.transfer.through');
  const pose = actions.pose();
  const { item } = state.selection.value;
  const keys = { smaller: key('brush.smaller'), larger: key('brush.larger'), next: key('transfer.next') };
  if (state.tool.value !== 'paint-pair') return t('status.transfer.pick', { paint: key('tool.paint-pair') });
  const handle = item === null ? undefined : pose?.handles[item];
  if (!handle)
    return actions.open().length > 0 ? t('status.transfer.none', keys) : t('status.transfer.done', keys);
  const name = actions.handleName(item!, pose);
  return handle.kind === 'point'
    ? t('status.transfer.point', { ...keys, name })
    : t('status.transfer.paint', { ...keys, name });
}
