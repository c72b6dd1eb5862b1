import type { Command } from '../commands';
import type { CommandContext } from './context';

/** Each press of [ or ] changes the brush by this factor. */
const STEP = 1.2;
const SMALLEST = 2;
const LARGEST = 400;

export function brushCommands({ state, wings }: CommandContext): Command[] {
  const group = 'tool';
  const resize = (factor: number) => () => {
    state.brushSize.value = Math.min(LARGEST, Math.max(SMALLEST, Math.round(state.brushSize.value * factor)));
  };
  return [
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
      enabled: () => wings.open.value?.wing.mirrors ?? false,
      checked: () => state.mirror.value,
      run: () => {
        state.mirror.value = !state.mirror.value;
      },
    },
  ];
}
