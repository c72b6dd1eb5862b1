// Which shortcut runs which command: the registry's defaults under the person's own changes.

import type { KeymapService, SettingsService } from './api';
import type { Commands } from './commands';
import { type Focused, isSingleKey, type KeyPress, keyLabel, keyOf, ownsKey } from './keys';

export class Keymap implements KeymapService {
  constructor(
    private readonly commands: Commands,
    private readonly settings: SettingsService,
    private readonly mac: boolean,
  ) {}

  keys(command: string): readonly string[] {
    return this.settings.values.value.keys[command] ?? this.commands.get(command).keys ?? [];
  }

  label(key: string): string {
    return keyLabel(key, this.mac);
  }

  hint(command: string): string {
    const key = this.keys(command).find((each) => this.#isOn(each));
    return key === undefined ? '' : this.label(key);
  }

  keyOf(press: KeyPress): string | null {
    return keyOf(press, this.mac);
  }

  ownerOf(key: string, command?: string): string | null {
    const place = command === undefined ? undefined : this.commands.get(command).workspace;
    const owner = this.commands.all.find(
      (each) => each.id !== command && this.keys(each.id).includes(key) && meet(each.workspace, place),
    );
    return owner?.id ?? null;
  }

  /** A shortcut has one owner in each workspace: whoever held one of `keys` loses it. */
  rebind(command: string, keys: readonly string[]): void {
    const place = this.commands.get(command).workspace;
    const changed: Record<string, readonly string[]> = { ...this.settings.values.value.keys };
    for (const { id, workspace } of this.commands.all) {
      const held = this.keys(id);
      if (id !== command && meet(workspace, place) && held.some((key) => keys.includes(key)))
        changed[id] = held.filter((key) => !keys.includes(key));
    }
    this.settings.update({ keys: { ...changed, [command]: keys } });
  }

  resetAll(): void {
    this.settings.update({ keys: {} });
  }

  /** The command a key press runs now, `null` when the key belongs to someone else or does nothing. */
  commandFor(press: KeyPress, focused: Focused | null): string | null {
    const key = this.keyOf(press);
    if (key === null || ownsKey(focused, key) || !this.#isOn(key)) return null;
    const owner = this.commands.all.find(
      (command) => this.commands.isAtHand(command) && this.keys(command.id).includes(key),
    );
    return owner && this.commands.isEnabled(owner.id) ? owner.id : null;
  }

  #isOn(key: string): boolean {
    return this.settings.values.value.singleKeys || !isSingleKey(key);
  }
}

/** Whether commands of the two workspaces can be at hand at once; `undefined` is every one. */
const meet = (a: string | undefined, b: string | undefined): boolean =>
  a === undefined || b === undefined || a === b;
