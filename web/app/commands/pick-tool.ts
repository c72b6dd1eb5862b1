import type { Command } from '../commands';
import type { MessageKey } from '../i18n';
import type { TOOLS, ToolId, WorkspaceId } from '../state';
import type { CommandContext } from './context';

/** Makes the commands that take up a workspace's tools. @param onPick  what taking one up does beside */
export const pickTool =
  <W extends WorkspaceId>(
    workspace: W,
    { state, gestures }: CommandContext,
    onPick?: (id: (typeof TOOLS)[W][number]) => void,
  ) =>
  (id: (typeof TOOLS)[W][number] & ToolId, icon: string, keys: readonly string[]): Command => ({
    id: `tool.${id}`,
    group: 'tool',
    workspace,
    title: `command.tool.${id}` satisfies MessageKey,
    icon,
    keys,
    checked: () => state.tool.value === id,
    run: () => {
      gestures.cancel();
      state.tool.value = id;
      onPick?.(id);
    },
  });
