import type { WorkspaceId } from '../../recipe/recipe';
import type { Command } from '../commands';
import type { MessageKey } from '../i18n';
import type { State } from '../state';
import type { Gestures } from '../wing';

/** The ids that have a name among the messages. */
export type ToolId =
  Extract<MessageKey, `command.tool.${string}`> extends `command.tool.${infer T}` ? T : never;

interface Context {
  readonly state: Pick<State, 'tool'>;
  readonly gestures: Gestures;
}

/** Makes the commands that take up a workspace's tools. @param onPick  what taking one up does beside */
export const pickTool =
  <T extends ToolId>(workspace: WorkspaceId, { state, gestures }: Context, onPick?: (id: T) => void) =>
  (id: T, icon: string, keys: readonly string[]): Command => ({
    id: `tool.${id}`,
    group: 'tool',
    workspace,
    title: `command.tool.${id}` as MessageKey,
    icon,
    keys,
    checked: () => state.tool.value === id,
    run: () => {
      gestures.cancel();
      state.tool.value = id;
      onPick?.(id);
    },
  });
