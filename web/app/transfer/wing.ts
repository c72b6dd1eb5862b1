// The transfer wing: the pose of one model given to another.

import { isEmpty } from '../../core/vertex-set';
import type { Recipe } from '../../recipe/recipe';
import type { Evaluation } from '../evaluated';
import words from '../locales/en/transfer.json';
import { listed } from '../painted-regions';
import type { Wing } from '../wing';
import type { WingParts } from '../wing-parts';
import { lastOf } from '../workspaces';
import { TransferActions } from './actions';
import { TOOLS, transferCommands } from './commands';
import { FEWEST_PAIRS, transferStrategy } from './evaluation';
import { Follow } from './follow';
import { TransferState } from './state';
import { transferStatus } from './status';
import { mountTransfer } from './view-sync';

export { words };

export interface TransferWing extends Wing {
  readonly state: TransferState;
  readonly actions: TransferActions;
}

export function create(parts: WingParts): TransferWing {
  const { state } = parts;
  const own = new TransferState(state);
  const follow = new Follow(own, parts);
  const actions = new TransferActions(parts, own, follow);
  return {
    state: own,
    actions,
    tools: TOOLS,
    group: 'transfer',
    commands: transferCommands(parts, own, actions),
    strategy: transferStrategy(own),
    start: () => actions.target.start(),
    last: (recipe) => lastTransfer(recipe, state.step.peek()?.id),
    isIdle: (step) =>
      step.type === 'transfer' &&
      step.through === undefined &&
      step.handles.filter((set) => !isEmpty(set)).length < FEWEST_PAIRS,
    publish: (shown) => follow.publish(shown),
    warnings,
    status: (key) => transferStatus(state, actions, key),
    selected: () => {
      const { item } = state.selection.peek();
      const set = item === null ? undefined : own.step.peek()?.handles[item];
      return set && listed(set, state.facts.peek()?.vertices ?? 0);
    },
    mount: (viewport) => mountTransfer(viewport, parts, own, actions),
  };
}

/** The last transfer of the open step's pose, else the last one of all. */
const lastTransfer = (recipe: Recipe, open: string | undefined): string | undefined =>
  recipe.steps.findLast((step) => step.type === 'transfer' && step.like === open)?.id ??
  lastOf(recipe, 'transfer');

/** What the list of pairs shows anyway. */
const SHOWN = ['unpaired-handle', 'few-pairs'];

/** What the model's file is like is no news where it gets a pose. */
function warnings({ report, inputs }: Evaluation) {
  const known = new Set(inputs[0]?.opened.findings.map(({ code }) => code));
  return (report?.warnings ?? []).filter(({ code }) => !known.has(code) && !SHOWN.includes(code));
}
