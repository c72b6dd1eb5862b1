// The hair wing: strands that grow along what is drawn on a head.

import words from '../locales/en/hair.json';
import type { Wing } from '../wing';
import type { WingParts } from '../wing-parts';
import { HairActions } from './actions';
import { hairCommands, TOOLS } from './commands';
import { hairStrategy } from './evaluation';
import { strandsExport } from './export';
import { hairFigures } from './figures';
import { Looking } from './looking';
import { FirstSight, hideCurvesAtFirst } from './opening';
import { hairRecipeOn, startHair } from './start';
import { HairState } from './state';
import { hairStatus } from './status';
import { mountHair } from './view-sync';

export { words };

export interface HairWing extends Wing {
  readonly state: HairState;
  readonly actions: HairActions;
}

export function create(parts: WingParts): HairWing {
  const { state } = parts;
  const own = new HairState(state);
  const actions = new HairActions(parts, own);
  const sight = new FirstSight();
  const looking = new Looking(parts);
  return {
    state: own,
    actions,
    tools: TOOLS,
    group: 'hair',
    commands: hairCommands(parts, own, actions),
    strategy: hairStrategy,
    mirrors: true,
    exports: strandsExport(),
    start: () => startHair(parts),
    opening: ({ name, scalp }) => (scalp ? hairRecipeOn(name) : undefined),
    publish: (shown) => {
      own.figures.value = shown && hairFigures(shown, own.figures.peek());
    },
    warnings: ({ report, shown }) => {
      // A head is open at the neck and has eyes: what its file is like is no news here.
      const known = new Set(shown.opened.findings.map(({ code }) => code));
      return (report?.warnings ?? []).filter(({ code }) => !known.has(code));
    },
    status: (key) => hairStatus(state, own, key),
    take: (file) => looking.take(file),
    dispose: hideCurvesAtFirst(state, own),
    mount: (viewport) => mountHair(viewport, parts, own, sight),
  };
}
