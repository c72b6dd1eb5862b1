// The merge wing: one model's part put onto another.

import { LissomError } from '../../core/errors';
import type { Evaluation } from '../evaluated';
import { t } from '../i18n';
import words from '../locales/en/merge.json';
import type { Wing } from '../wing';
import type { WingParts } from '../wing-parts';
import { MergeActions } from './actions';
import { mergeCommands, TOOLS } from './commands';
import { mergeStrategy, publishMerge } from './evaluation';
import { MergeState } from './state';
import { mergeStatus } from './status';
import { mountMerge } from './view-sync';

export { words };

export interface MergeWing extends Wing {
  readonly state: MergeState;
  readonly actions: MergeActions;
}

export function create(parts: WingParts): MergeWing {
  const { state, workspaces } = parts;
  const own = new MergeState(parts);
  const actions = new MergeActions(parts, own);
  return {
    state: own,
    actions,
    tools: TOOLS,
    group: 'merge',
    commands: mergeCommands(parts, own, actions),
    strategy: mergeStrategy(own),
    async start() {
      const target = workspaces.openModel();
      if (target === undefined) throw new LissomError('no-model', t('error.no-model'));
      await actions.part.start(target);
    },
    publish: (shown) => publishMerge(own, shown),
    warnings,
    status: (key) => mergeStatus(state, own, key),
    escape: () => {
      const held = own.picked.peek() !== null;
      own.picked.value = null;
      return held;
    },
    mount: () => mountMerge(parts, own, actions),
  };
}

/** What a merge reports of its own finds: the pins and the seam show it. */
const FOUND = ['key-found', 'boundary-refined'];

/** What the part's file is like is no news where models are put together. */
function warnings({ report, inputs }: Evaluation) {
  const known = new Set(inputs[0]?.opened.findings.map(({ code }) => code));
  return (report?.warnings ?? []).filter(({ code }) => !known.has(code) && !FOUND.includes(code));
}
