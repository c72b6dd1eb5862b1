import type { Command } from '../commands';
import type { DialogId } from '../state';
import type { CommandContext } from './context';

export function helpCommands({ state }: CommandContext): Command[] {
  const group = 'help';
  const dialog = (id: DialogId) => () => {
    state.dialog.value = state.dialog.value === id ? null : id;
  };
  return [
    {
      id: 'help.palette',
      group,
      title: 'command.help.palette',
      icon: 'command',
      keys: ['Mod+K'],
      hidden: true,
      run: dialog('palette'),
    },
    {
      id: 'help.shortcuts',
      group,
      title: 'command.help.shortcuts',
      icon: 'circle-help',
      keys: ['?', 'F1'],
      run: dialog('help'),
    },
    {
      id: 'help.settings',
      group,
      title: 'command.help.settings',
      icon: 'settings',
      keys: ['Mod+,'],
      run: dialog('settings'),
    },
  ];
}
