import type { Command } from '../commands';
import type { CommandContext } from './context';
import { editCommands } from './edit';
import { fileCommands } from './file';
import { handleCommands } from './handle';
import { helpCommands } from './help';
import { toolCommands } from './tool';
import { viewCommands } from './view';

/** Every command, in the order menus and the help sheet list them. */
export const allCommands = (context: CommandContext): Command[] =>
  [fileCommands, editCommands, toolCommands, handleCommands, viewCommands, helpCommands].flatMap((commands) =>
    commands(context),
  );
