// The blend wing: shapes between models that were matched.

import { stepRow } from '../../recipe/recipe';
import type { Evaluation } from '../evaluated';
import { t } from '../i18n';
import { leadTo } from '../lead-to';
import words from '../locales/en/blend.json';
import type { Wing } from '../wing';
import type { WingParts } from '../wing-parts';
import { BlendActions } from './actions';
import { blendCommands, TOOLS } from './commands';
import { blendStrategy } from './evaluation';
import { Follow } from './follow';
import { matchFor } from './matches';
import { BlendState } from './state';
import { blendStatus } from './status';
import { mountBlend } from './view-sync';

export { words };

export interface BlendWing extends Wing {
  readonly state: BlendState;
  readonly actions: BlendActions;
}

export function create(parts: WingParts): BlendWing {
  const { state, document } = parts;
  const own = new BlendState(state);
  const follow = new Follow(own, parts);
  const actions = new BlendActions(parts, own);
  return {
    state: own,
    actions,
    tools: TOOLS,
    group: 'blend',
    commands: blendCommands(parts, own, actions),
    strategy: blendStrategy(own),
    async start() {
      if (matchFor(document.recipe, document.selection.step)) actions.start();
      else
        leadTo(
          stepRow('match').workspace,
          { text: t('error.blend-no-match'), label: t('blend.to-match') },
          parts,
        );
    },
    publish: (shown) => follow.publish(shown),
    warnings,
    status: (key) => blendStatus(state, own, key),
    selected: () => actions.selected(),
    mirrors: true,
    escape: () => {
      const begun = own.length.peek() !== null;
      own.length.value = null;
      return begun;
    },
    mount: (viewport) => mountBlend(viewport, parts, own, actions),
  };
}

/** What the models' files are like is no news where they are blended. */
function warnings({ report, inputs }: Evaluation) {
  const known = new Set(inputs[0]?.opened.findings.map(({ code }) => code));
  return (report?.warnings ?? []).filter(({ code }) => !known.has(code));
}
