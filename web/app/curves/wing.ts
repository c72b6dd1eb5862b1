// The curves wing: curves drawn on a model bend it.

import { newCurvesStep } from '../../recipe/steps/curves';
import words from '../locales/en/curves.json';
import type { Wing } from '../wing';
import type { WingParts } from '../wing-parts';
import { CurvesActions } from './actions';
import { curvesCommands, TOOLS } from './commands';
import { curvesStrategy } from './evaluation';
import { skinExport } from './export';
import { Follow } from './follow';
import { startCurves } from './start';
import { CurvesState } from './state';
import { curvesStatus } from './status';
import { mountCurves } from './view-sync';

export { words };

export interface CurvesWing extends Wing {
  readonly state: CurvesState;
  readonly actions: CurvesActions;
}

export function create(parts: WingParts): CurvesWing {
  const { state } = parts;
  const own = new CurvesState(state);
  const actions = new CurvesActions(parts, own);
  const follow = new Follow(own, parts);
  return {
    state: own,
    actions,
    tools: TOOLS,
    group: 'curves',
    commands: curvesCommands(parts, own, actions, follow),
    strategy: curvesStrategy(own),
    mirrors: true,
    exports: skinExport(parts),
    start: async () => startCurves(parts),
    stepOn: newCurvesStep,
    isIdle: (step) => step.type === 'curves' && step.curves.length === 0,
    publish: (shown) => follow.publish(shown),
    status: (key) => curvesStatus(state, own, key),
    escape: () => actions.player.stop() || actions.hand.letGo(),
    selected: () => {
      const grip = own.grip.peek();
      return grip ? own.prepared.peek()?.curves[grip.curve]?.region : undefined;
    },
    mount: (viewport) => mountCurves(viewport, parts, own, actions),
  };
}
