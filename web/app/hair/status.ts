// The status bar's sentence in the hair workspace.

import { ponytailStage } from '../../tools/hair/ponytail-tool';
import { primitiveAt } from '../../tools/hair/style';
import { t } from '../i18n';
import type { State } from '../state';
import type { HairState } from './state';

type Keys = (command: string) => string;

/** Reads signals. @param key  the shortcut of a command as it is shown */
export function hairStatus(state: State, own: HairState, key: Keys): string {
  const aimed = own.aimed.value;
  const kind = selectedKind(state, own);
  switch (state.tool.value) {
    case 'stream':
      return aimed ? t('status.hair.stream', { hint: key('tool.hint') }) : t('status.hair.off-head');
    case 'parting':
      if (!aimed) return t('status.hair.off-head');
      return kind === 'parting' ? t('status.hair.tilt') : t('status.hair.parting');
    case 'hint':
      return hintStatus(kind, key);
    case 'ponytail':
      return ponytailStatus(state, own, key);
    case 'paint-scalp':
      return t('status.hair.scalp', { smaller: key('brush.smaller'), larger: key('brush.larger') });
    case 'paint-length': {
      const percent = Math.round(100 * own.lengthBrush.value);
      const brush = { smaller: key('brush.smaller'), larger: key('brush.larger') };
      return t('status.hair.length', { percent, ...brush });
    }
    default:
      if (kind === undefined) return restStatus(own, key);
      return t('status.hair.selected', { hint: key('tool.hint') });
  }
}

function selectedKind(state: State, own: HairState) {
  const step = own.step.value;
  return step && primitiveAt(step, state.selection.value.item)?.kind;
}

/** Nothing is selected; a style that has only been opened shows no curves to click. */
function restStatus(own: HairState, key: Keys): string {
  const stream = key('tool.stream');
  if (own.show.value.curves) return t('status.hair.select', { stream });
  return t('status.hair.look', { stream, curves: key('hair.show-curves') });
}

function hintStatus(kind: ReturnType<typeof selectedKind>, key: Keys): string {
  if (!kind) return t('status.hair.hint-none');
  if (kind === 'parting') return t('status.hair.tilt');
  return t('status.hair.hint', { rebuild: key('hair.rebuild-support'), kind: key('hair.support-kind') });
}

/** What to draw next of the ponytail being built. */
function ponytailStatus(state: State, own: HairState, key: Keys): string {
  const step = own.step.value;
  const stage = step ? ponytailStage({ step, selected: state.selection.value.item }) : 'spine';
  if (stage === 'spine' && !own.aimed.value) return t('status.hair.off-head');
  return t(`status.hair.ponytail.${stage}`, {
    rebuild: key('hair.rebuild-support'),
    done: key('hair.done'),
  });
}
