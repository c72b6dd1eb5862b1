import type { Command } from '../commands';
import { WORKSPACES, wings } from '../wings';
import type { CommandContext } from './context';

export const workspaceCommands = ({ state, workspaces }: CommandContext): Command[] =>
  WORKSPACES.map((id) => ({
    id: `workspace.${id}`,
    group: 'view',
    title: `wing.${id}.enter`,
    icon: wings[id].icon,
    keys: [wings[id].key],
    checked: () => state.workspace.value === id,
    run: () => workspaces.enter(id),
  }));
