import type { Command } from '../commands';
import type { MessageKey } from '../i18n';
import type { WorkspaceId } from '../state';
import type { CommandContext } from './context';

export function workspaceCommands({ state, workspaces }: CommandContext): Command[] {
  const enter = (id: WorkspaceId, key: string, icon: string): Command => ({
    id: `workspace.${id}`,
    group: 'view',
    title: `command.workspace.${id}` satisfies MessageKey,
    icon,
    keys: [key],
    checked: () => state.workspace.value === id,
    run: () => workspaces.enter(id),
  });
  return [
    enter('deform', 'Shift+1', 'move'),
    enter('hair', 'Shift+2', 'spline'),
    enter('merge', 'Shift+3', 'combine'),
  ];
}
