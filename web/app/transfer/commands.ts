import type { Command } from '../commands';
import { pickTool } from '../commands/pick-tool';
import { selectedItem } from '../commands/selected-item';
import type { WingParts } from '../wing-parts';
import type { TransferActions } from './actions';
import type { TransferState } from './state';

export const TOOLS = ['pick-pair', 'paint-pair'] as const;

type Context = Pick<WingParts, 'state' | 'document' | 'gestures' | 'workspaces'>;

export function transferCommands(context: Context, own: TransferState, transfer: TransferActions): Command[] {
  const { state, document, workspaces } = context;
  const workspace = 'transfer';
  const group = 'transfer';
  const open = () => own.step.value !== undefined && !state.choosing.value;
  const posed = () => open() && own.figures.value !== null;
  const { selected, onSelected, stepped } = selectedItem(state);
  const count = () => (open() ? (transfer.pose()?.handles.length ?? 0) : 0);
  const tool = pickTool<(typeof TOOLS)[number]>(workspace, context);
  return [
    tool('pick-pair', 'mouse-pointer-2', ['V']),
    tool('paint-pair', 'paintbrush', ['B']),
    {
      id: 'transfer.next',
      group,
      workspace,
      title: 'command.transfer.next',
      icon: 'chevron-right',
      keys: ['N'],
      enabled: () => open() && transfer.open().length > 0,
      run: () => transfer.pickNext(),
    },
    {
      id: 'transfer.forward',
      group,
      workspace,
      title: 'command.transfer.forward',
      keys: ['.'],
      enabled: () => count() > 0,
      run: () => document.select(stepped(1, count())),
    },
    {
      id: 'transfer.backward',
      group,
      workspace,
      title: 'command.transfer.backward',
      keys: [','],
      enabled: () => count() > 0,
      run: () => document.select(stepped(-1, count())),
    },
    {
      id: 'transfer.by-name',
      group,
      workspace,
      title: 'command.transfer.by-name',
      icon: 'tag',
      enabled: () => open() && transfer.byName(own.step.value!) !== own.step.value,
      run: () => transfer.pairByName(),
    },
    {
      id: 'transfer.clear',
      group,
      workspace,
      title: 'command.transfer.clear',
      icon: 'trash-2',
      keys: ['Delete', 'Backspace'],
      enabled: () => open() && selected(),
      run: onSelected((handle) => transfer.clear(handle)),
    },
    {
      id: 'transfer.deselect',
      group,
      workspace,
      title: 'command.transfer.deselect',
      enabled: selected,
      run: () => document.select(null),
    },
    {
      id: 'transfer.rest',
      group,
      workspace,
      title: 'command.transfer.rest',
      icon: 'rotate-ccw',
      keys: ['T'],
      enabled: open,
      checked: () => own.atRest.value,
      run: () => {
        own.atRest.value = !own.atRest.value;
      },
    },
    {
      id: 'transfer.edit-pose',
      group,
      workspace,
      title: 'command.transfer.edit-pose',
      icon: 'pencil',
      enabled: () => open() && (transfer.pose() !== undefined || transfer.isThrough()),
      run: () => transfer.editPose(),
    },
    {
      id: 'transfer.new-pose',
      group,
      workspace,
      title: 'command.transfer.new-pose',
      icon: 'plus',
      enabled: () => open() && transfer.pose() !== undefined,
      run: () => transfer.newPose(),
    },
    {
      id: 'transfer.target',
      group,
      workspace,
      title: 'command.transfer.target',
      icon: 'box',
      enabled: () => open() && !transfer.isThrough(),
      run: () => transfer.target.change(),
    },
    {
      id: 'transfer.another',
      group,
      workspace,
      title: 'command.transfer.another',
      icon: 'copy-plus',
      enabled: open,
      run: () => transfer.target.start(),
    },
    {
      id: 'transfer.deform',
      group,
      workspace,
      title: 'command.transfer.deform',
      icon: 'move',
      enabled: posed,
      run: () => workspaces.enter('deform'),
    },
  ];
}
