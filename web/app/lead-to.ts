import type { WorkspaceId } from '../recipe/recipe';
import type { WingParts } from './wing-parts';

/** Says what is missing, and leads to where it is made. @param workspace  `null`: nowhere on screen */
export function leadTo(
  workspace: WorkspaceId | null,
  { text, label }: { readonly text: string; readonly label: string },
  { messages, workspaces }: Pick<WingParts, 'messages' | 'workspaces'>,
): void {
  if (workspace === null) {
    messages.toast('warn', text);
    return;
  }
  const run = (): void => {
    workspaces.enter(workspace).catch((error: unknown) => messages.failed(error));
  };
  messages.toast('warn', text, { label, run });
}
