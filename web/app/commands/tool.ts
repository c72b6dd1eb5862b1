import type { Command } from '../commands';
import type { CommandContext } from './context';
import { pickTool } from './pick-tool';

/** Each press of [ or ] changes the brush by this factor. */
const STEP = 1.2;
const SMALLEST = 2;
const LARGEST = 400;

export function toolCommands(context: CommandContext): Command[] {
  const { state, deform } = context;
  const group = 'tool';
  const workspace = 'deform';
  const tool = pickTool(workspace, context);
  const resize = (factor: number) => () => {
    state.brushSize.value = Math.min(LARGEST, Math.max(SMALLEST, Math.round(state.brushSize.value * factor)));
  };
  return [
    tool('select', 'mouse-pointer-2', ['V']),
    tool('paint-roi', 'paintbrush', ['B']),
    tool('paint-handle', 'grab', ['H']),
    tool('point-handle', 'circle-dot', ['P']),
    {
      id: 'brush.smaller',
      group,
      title: 'command.brush.smaller',
      icon: 'minus',
      keys: ['['],
      run: resize(1 / STEP),
    },
    {
      id: 'brush.larger',
      group,
      title: 'command.brush.larger',
      icon: 'plus',
      keys: [']'],
      run: resize(STEP),
    },
    {
      id: 'brush.erase',
      group,
      title: 'command.brush.erase',
      icon: 'eraser',
      keys: ['X'],
      checked: () => state.brushMode.value === 'erase',
      run: () => {
        state.brushMode.value = state.brushMode.value === 'erase' ? 'add' : 'erase';
      },
    },
    {
      id: 'brush.mirror',
      group,
      title: 'command.brush.mirror',
      icon: 'flip-horizontal-2',
      keys: ['M'],
      // Two models to merge have no plane of symmetry in common.
      enabled: () => state.workspace.value !== 'merge',
      checked: () => state.mirror.value,
      run: () => {
        state.mirror.value = !state.mirror.value;
      },
    },
    {
      id: 'roi.everything',
      group,
      workspace,
      title: 'command.roi.everything',
      icon: 'maximize',
      keys: ['A'],
      enabled: () => state.step.value !== undefined,
      run: () => deform.setRoi('all'),
    },
    {
      id: 'roi.clear',
      group,
      workspace,
      title: 'command.roi.clear',

      enabled: () => state.step.value !== undefined,
      run: () => deform.setRoi([]),
    },
  ];
}
