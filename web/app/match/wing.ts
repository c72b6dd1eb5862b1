// The match wing: one connectivity for several models.

import { producedNames } from '../../recipe/references';
import type { Evaluation } from '../evaluated';
import words from '../locales/en/match.json';
import type { Wing } from '../wing';
import type { WingParts } from '../wing-parts';
import { MatchActions } from './actions';
import { matchCommands, TOOLS } from './commands';
import { matchStrategy, publishMatch } from './evaluation';
import { skinsExport } from './exports';
import { followGhosts } from './ghosts';
import { followKept } from './kept';
import { MatchState } from './state';
import { matchStatus } from './status';
import { mountMatch } from './view-sync';

export { words };

export interface MatchWing extends Wing {
  readonly state: MatchState;
  readonly actions: MatchActions;
}

export function create(parts: WingParts): MatchWing {
  const { state } = parts;
  const own = new MatchState(parts);
  const actions = new MatchActions(parts, own);
  const stops = [followGhosts(own, parts), followKept(own, parts)];
  return {
    state: own,
    actions,
    tools: TOOLS,
    group: 'match',
    commands: matchCommands(parts, own, actions),
    strategy: matchStrategy(own),
    mirrors: true,
    start: () => actions.models.start(),
    isIdle: (step) =>
      step.type === 'match' && step.markers.length === 0 && own.result.value?.of.id !== step.id,
    resultOf: (step) => producedNames(step)[own.chosen.value],
    results: () => own.result.value?.models ?? [],
    publish: (shown) => publishMatch(own, shown),
    warnings,
    status: (key) => matchStatus(state, own, actions, key),
    escape: () => {
      const looked = own.poor.peek() !== null;
      own.poor.value = null;
      return looked;
    },
    get exports() {
      return own.result.value ? skinsExport(own) : undefined;
    },
    fit: () => {
      for (const { viewport } of parts.panes.take(Math.max(0, own.models.peek().length - 1)) ?? [])
        viewport.fit();
    },
    mount: (viewport) => mountMatch(viewport, parts, own, actions),
    dispose: () => {
      for (const stop of stops) stop();
    },
  };
}

/** What the list of markers shows anyway. */
const SHOWN = ['marker-incomplete', 'curve-incomplete'];

/** What a model's file is like is no news where models are matched. */
function warnings({ report, inputs }: Evaluation) {
  const known = new Set(inputs.flatMap(({ opened }) => opened.findings.map(({ code }) => code)));
  return (report?.warnings ?? []).filter(({ code }) => !known.has(code) && !SHOWN.includes(code));
}
