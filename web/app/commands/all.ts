import type { Command } from '../commands';
import type { Wing } from '../wing';
import { brushCommands } from './brush';
import type { CommandContext } from './context';
import { editCommands } from './edit';
import { fileCommands } from './file';
import { helpCommands } from './help';
import { viewCommands } from './view';
import { workspaceCommands } from './workspace';

/**
 * Every command there is now, in the order menus and the help sheet list them. Reads signals.
 * @param wings  those that are loaded, in the order of their registry
 */
export function allCommands(context: CommandContext, wings: () => Iterable<Wing>): () => Command[] {
  const of = (lists: readonly ((context: CommandContext) => Command[])[]) =>
    lists.flatMap((list) => list(context));
  const first = of([fileCommands, editCommands, brushCommands]);
  const last = of([viewCommands, workspaceCommands, helpCommands]);
  return () => [...first, ...[...wings()].flatMap(({ commands }) => commands), ...last];
}
