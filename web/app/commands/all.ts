import type { Command } from '../commands';
import type { CommandContext } from './context';
import { editCommands } from './edit';
import { fileCommands } from './file';
import { hairCommands } from './hair';
import { handleCommands } from './handle';
import { helpCommands } from './help';
import { mergeCommands } from './merge';
import { toolCommands } from './tool';
import { viewCommands } from './view';
import { workspaceCommands } from './workspace';

/** Every command, in the order menus and the help sheet list them. */
export const allCommands = (context: CommandContext): Command[] =>
  [
    fileCommands,
    editCommands,
    toolCommands,
    handleCommands,
    hairCommands,
    mergeCommands,
    viewCommands,
    workspaceCommands,
    helpCommands,
  ].flatMap((commands) => commands(context));
