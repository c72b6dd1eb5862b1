// The deform wing: handles bend a region of the model.

import { toIndices } from '../../core/vertex-set';
import { newDeformStep } from '../../recipe/steps/deform';
import words from '../locales/en/deform.json';
import type { Wing } from '../wing';
import type { WingParts } from '../wing-parts';
import { DeformActions } from './actions';
import { deformCommands, TOOLS } from './commands';
import { deformStrategy } from './evaluation';
import { EffectFigures } from './figures';
import { lastDeform, openingRecipe, startDeform } from './start';
import { DeformState } from './state';
import { deformStatus } from './status';
import { mountDeform } from './view-sync';

export { words };

export interface DeformWing extends Wing {
  readonly state: DeformState;
  readonly actions: DeformActions;
}

export function create(parts: WingParts): DeformWing {
  const { state, document, evaluator } = parts;
  const own = new DeformState(state);
  const actions = new DeformActions(document, evaluator, own);
  const figures = new EffectFigures(own, parts);
  return {
    state: own,
    actions,
    tools: TOOLS,
    group: 'handle',
    commands: deformCommands(parts, own, actions),
    strategy: deformStrategy(own),
    mirrors: true,
    start: async () => startDeform(parts),
    stepOn: newDeformStep,
    last: (recipe) => lastDeform(recipe, state.step.peek()?.id),
    isIdle: (step) => step.type === 'deform' && step.handles.length === 0,
    opening: openingRecipe,
    publish: (shown) => figures.publish(shown),
    status: (key) => deformStatus(parts, own, key),
    selected: () => {
      const { item } = state.selection.peek();
      const handle = item === null ? undefined : own.step.peek()?.handles[item];
      return handle && toIndices(handle.vertices, state.facts.peek()?.vertices ?? 0);
    },
    mount: (viewport) => mountDeform(viewport, parts, own),
  };
}
