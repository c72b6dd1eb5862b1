// The dress wing: what was made for one body on another.

import { stepRow } from '../../recipe/recipe';
import type { Evaluation } from '../evaluated';
import { t } from '../i18n';
import { leadTo } from '../lead-to';
import words from '../locales/en/dress.json';
import type { Wing } from '../wing';
import type { WingParts } from '../wing-parts';
import { DressActions } from './actions';
import { dressCommands, TOOLS } from './commands';
import { dressStrategy } from './evaluation';
import { Follow } from './follow';
import { DressState } from './state';
import { dressStatus } from './status';
import { mountDress } from './view-sync';

export { words };

export interface DressWing extends Wing {
  readonly state: DressState;
  readonly actions: DressActions;
}

export function create(parts: WingParts): DressWing {
  const { state } = parts;
  const own = new DressState(state);
  const follow = new Follow(own, parts);
  const actions = new DressActions(parts, own);
  return {
    state: own,
    actions,
    tools: TOOLS,
    group: 'dress',
    commands: dressCommands(parts, own, actions),
    strategy: dressStrategy,
    async start() {
      if (actions.choice.canStart) await actions.choice.start();
      else
        leadTo(
          stepRow('match').workspace,
          { text: t('error.dress-no-match'), label: t('dress.to-match') },
          parts,
        );
    },
    publish: (shown) => follow.publish(shown),
    warnings,
    status: () => dressStatus(state, own),
    mount: (viewport) => mountDress(viewport, parts, own),
  };
}

/** That a garment is open is no news. */
function warnings({ report, inputs }: Evaluation) {
  const known = new Set(inputs[0]?.opened.findings.map(({ code }) => code));
  return (report?.warnings ?? []).filter(({ code }) => !known.has(code));
}
