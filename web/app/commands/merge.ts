import type { Command } from '../commands';
import type { CommandContext } from './context';
import { pickTool } from './pick-tool';

export function mergeCommands(context: CommandContext): Command[] {
  const { state, merge, document, workspaces } = context;
  const workspace = 'merge';
  const group = 'merge';
  const open = () => state.mergeStep.value !== undefined && !state.choosing.value;
  const pin = () => state.selection.value.handle;
  const tool = pickTool(workspace, context);
  return [
    tool('merge-pins', 'map-pin', ['V']),
    tool('mark-region', 'paintbrush', ['B']),
    tool('mark-feature', 'highlighter', ['C']),
    {
      id: 'merge.through',
      group,
      workspace,
      title: 'command.merge.through',
      icon: 'layers',
      keys: ['T'],
      checked: () => state.merge.through.value,
      run: () => {
        state.merge.through.value = !state.merge.through.value;
      },
    },
    {
      id: 'merge.run',
      group,
      workspace,
      title: 'command.merge.run',
      icon: 'combine',
      keys: ['Mod+Enter'],
      enabled: open,
      run: () => merge.merge(),
    },
    {
      id: 'merge.cut',
      group,
      workspace,
      title: 'command.merge.cut',
      icon: 'scissors',
      enabled: () => open() && state.mergeStep.value?.boundaries.length === 0,
      run: () => merge.cutAlongMarks(),
    },
    {
      id: 'merge.part',
      group,
      workspace,
      title: 'command.merge.part',
      icon: 'box',
      enabled: open,
      run: () => merge.changePart(),
    },
    {
      id: 'merge.another',
      group,
      workspace,
      title: 'command.merge.another',
      icon: 'plus',
      enabled: () => open() && state.merge.figures.value !== null,
      run: () => merge.start(state.mergeStep.value!.id),
    },
    {
      id: 'merge.deform',
      group,
      workspace,
      title: 'command.merge.deform',
      icon: 'move',
      enabled: () => open() && state.merge.figures.value !== null,
      run: () => workspaces.enter('deform'),
    },
    {
      id: 'merge.remove-pin',
      group,
      workspace,
      title: 'command.merge.remove-pin',
      icon: 'trash-2',
      keys: ['Delete', 'Backspace'],
      enabled: () => pin() !== null,
      run: () => {
        const number = pin();
        if (number !== null) merge.removePin(number);
      },
    },
    {
      id: 'merge.deselect',
      group,
      workspace,
      title: 'command.merge.deselect',
      enabled: () => pin() !== null || state.merge.picked.value !== null,
      run: () => {
        state.merge.picked.value = null;
        document.select(null);
      },
    },
    {
      id: 'merge.before',
      group,
      workspace,
      title: 'command.merge.before',
      icon: 'history',
      keys: ['Y'],
      enabled: () => open() && state.mergeStep.value?.optimalBoundary !== undefined,
      checked: () => state.merge.before.value,
      run: () => {
        state.merge.before.value = !state.merge.before.value;
      },
    },
  ];
}
