// The one command registry: menu, palette, shortcuts, tooltips and the help sheet are all made from it.
// The commands themselves are in commands/*.ts and with the wings; keymap.ts decides which keys reach them.

import { computed, type ReadonlySignal } from '@preact/signals';
import type { WorkspaceId } from '../recipe/recipe';
import type { MessageKey } from './i18n';

/** A wing may bring one of its own; its name is under `ui.group.…`. */
export type CommandGroup = 'file' | 'edit' | 'tool' | 'view' | 'help' | WingGroup;
type WingGroup = Extract<MessageKey, `ui.group.${string}`> extends `ui.group.${infer G}` ? G : never;

export interface Command {
  /** Stable: keymaps are stored under it. */
  readonly id: string;
  readonly group: CommandGroup;
  readonly title: MessageKey;
  /** Name of a Lucide icon, kebab-case. */
  readonly icon?: string;
  /** Default shortcuts, as keymap.ts writes them: `Mod+Shift+Z`, `B`, `[`, `Delete`. `Mod` is Cmd on a Mac. */
  readonly keys?: readonly string[];
  /** The only workspace it is of use in; absent: every one. Those of different ones may share shortcuts. */
  readonly workspace?: WorkspaceId;
  /** Reads signals, so components that call it follow. Absent: always. */
  readonly enabled?: () => boolean;
  /** For a command that switches something: whether it is on now. */
  readonly checked?: () => boolean;
  readonly run: () => void | Promise<void>;
  /** Not offered in the palette (a key only makes sense held or repeated). */
  readonly hidden?: boolean;
}

interface Lists {
  /** In the order menus and the help sheet list them. Reads signals: wings join as they are loaded. */
  readonly all: () => readonly Command[];
  /** Told of whatever a command throws. */
  readonly failed: (error: unknown) => void;
  /** The workspace that is open; reads signals. */
  readonly workspace: () => WorkspaceId;
}

export class Commands {
  readonly #byId: ReadonlySignal<ReadonlyMap<string, Command>>;

  constructor(private readonly lists: Lists) {
    this.#byId = computed(() => {
      const byId = new Map<string, Command>();
      for (const command of lists.all()) {
        if (byId.has(command.id)) throw new Error(`command ${command.id} is registered twice`);
        byId.set(command.id, command);
      }
      return byId;
    });
  }

  get all(): readonly Command[] {
    return [...this.#byId.value.values()];
  }

  get(id: string): Command {
    const command = this.#byId.value.get(id);
    if (!command) throw new Error(`no command ${id}`);
    return command;
  }

  isEnabled(id: string): boolean {
    const command = this.get(id);
    return this.isAtHand(command) && (command.enabled?.() ?? true);
  }

  /** Whether it belongs to the open workspace. */
  isAtHand({ workspace }: Command): boolean {
    return workspace === undefined || workspace === this.lists.workspace();
  }

  /** Runs the command unless it is disabled; a failure becomes a message, never an exception. */
  async run(id: string): Promise<void> {
    if (!this.isEnabled(id)) return;
    try {
      await this.get(id).run();
    } catch (error) {
      this.lists.failed(error);
    }
  }
}
