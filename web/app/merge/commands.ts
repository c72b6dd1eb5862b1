import type { Command } from '../commands';
import { pickTool } from '../commands/pick-tool';
import { selectedItem } from '../commands/selected-item';
import type { WingParts } from '../wing-parts';
import type { MergeActions } from './actions';
import type { MergeState } from './state';

export const TOOLS = ['merge-pins', 'mark-region', 'mark-feature'] as const;

type Context = Pick<WingParts, 'state' | 'document' | 'gestures' | 'workspaces'>;

export function mergeCommands(context: Context, own: MergeState, merge: MergeActions): Command[] {
  const { state, document, workspaces } = context;
  const workspace = 'merge';
  const group = 'merge';
  const open = () => own.step.value !== undefined && !state.choosing.value;
  const { selected, onSelected } = selectedItem(state);
  const tool = pickTool<(typeof TOOLS)[number]>(workspace, context);
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
      checked: () => own.through.value,
      run: () => {
        own.through.value = !own.through.value;
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
      run: () => merge.marking.merge(),
    },
    {
      id: 'merge.cut',
      group,
      workspace,
      title: 'command.merge.cut',
      icon: 'scissors',
      enabled: () => open() && own.step.value?.boundaries.length === 0,
      run: () => merge.marking.cutAlongMarks(),
    },
    {
      id: 'merge.part',
      group,
      workspace,
      title: 'command.merge.part',
      icon: 'box',
      enabled: open,
      run: () => merge.part.change(),
    },
    {
      id: 'merge.another',
      group,
      workspace,
      title: 'command.merge.another',
      icon: 'plus',
      enabled: () => open() && own.figures.value !== null,
      run: () => merge.part.start(own.step.value!.id),
    },
    {
      id: 'merge.deform',
      group,
      workspace,
      title: 'command.merge.deform',
      icon: 'move',
      enabled: () => open() && own.figures.value !== null,
      run: () => workspaces.enter('deform'),
    },
    {
      id: 'merge.remove-pin',
      group,
      workspace,
      title: 'command.merge.remove-pin',
      icon: 'trash-2',
      keys: ['Delete', 'Backspace'],
      enabled: selected,
      run: onSelected((number) => merge.joins.removePin(number)),
    },
    {
      id: 'merge.deselect',
      group,
      workspace,
      title: 'command.merge.deselect',
      enabled: () => selected() || own.picked.value !== null,
      run: () => {
        own.picked.value = null;
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
      enabled: () => open() && own.step.value?.optimalBoundary !== undefined,
      checked: () => own.before.value,
      run: () => {
        own.before.value = !own.before.value;
      },
    },
  ];
}
