// The status bar's sentence in the match workspace.

import { t } from '../i18n';
import type { State } from '../state';
import type { MatchActions } from './actions';
import type { MatchState } from './state';

/** Reads signals. @param key  the shortcut of a command as it is shown */
export function matchStatus(
  state: State,
  own: MatchState,
  actions: MatchActions,
  key: (command: string) => string,
): string {
  if (state.choosing.value) return t('status.match.choose');
  const tool = state.tool.value;
  if (tool === 'match-turn') return t('status.match.turn', { marker: key('tool.match-marker') });
  const brush = { smaller: key('brush.smaller'), larger: key('brush.larger') };
  if (tool === 'match-mask') return t('status.match.mask', brush);
  if (tool === 'match-sharp') return t('status.match.sharp', { remove: key('match.remove') });
  const at = actions.marking.nextModel();
  const name = at === null ? '' : (own.step.value?.models[at] ?? '');
  if (tool === 'match-curve')
    return at !== null && own.curve.value !== null
      ? t('status.match.curve-next', { number: own.curve.value + 1, name })
      : t('status.match.curve');
  const marker = own.marker.value;
  if (marker === null) return t('status.match.new', { turn: key('tool.match-turn') });
  const number = marker + 1;
  if (at === null) return t('status.match.set', { number, remove: key('match.remove') });
  return actions.marking.next()
    ? t('status.match.ghost', { number, name, accept: key('match.accept') })
    : t('status.match.next', { number, name });
}
