// The status bar's sentence in the blend workspace.

import { t } from '../i18n';
import type { State } from '../state';
import type { BlendState } from './state';

/** Reads signals. @param key  the shortcut of a command as it is shown */
export function blendStatus(
  state: Pick<State, 'tool' | 'selection'>,
  own: BlendState,
  key: (command: string) => string,
): string {
  const step = own.step.value;
  const keys = { smaller: key('brush.smaller'), larger: key('brush.larger'), paint: key('tool.paint-part') };
  if (state.tool.value === 'measure-girth') return t('status.blend.girth');
  if (state.tool.value === 'measure-length')
    return t(own.length.value ? 'status.blend.length-end' : 'status.blend.length');
  if (state.tool.value !== 'paint-part') return t('status.blend.pick', keys);
  const { item } = state.selection.value;
  return item !== null && step?.parts[item]
    ? t('status.blend.paint', {
        ...keys,
        name: step.parts[item].name ?? t('blend.part', { number: item + 1 }),
      })
    : t('status.blend.new', keys);
}
