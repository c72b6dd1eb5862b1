// What belongs to the person and this browser, not to the document: kept in localStorage.

import { type ReadonlySignal, signal } from '@preact/signals';
import type { Settings, SettingsService } from './api';

const KEY = 'lissom.settings';

export const DEFAULT_SETTINGS: Settings = { theme: 'dark', penOnly: false, singleKeys: true, keys: {} };

type Store = Pick<Storage, 'getItem' | 'setItem'>;

export class StoredSettings implements SettingsService {
  readonly #values = signal<Settings>(DEFAULT_SETTINGS);

  /** @param store  `null` where the browser forbids storage: the settings then last as long as the page */
  constructor(private readonly store: Store | null) {
    this.#values.value = read(store);
  }

  get values(): ReadonlySignal<Settings> {
    return this.#values;
  }

  update(change: Partial<Settings>): void {
    this.#values.value = { ...this.#values.value, ...change };
    try {
      this.store?.setItem(KEY, JSON.stringify(this.#values.value));
    } catch {
      // A full or forbidden store: the setting holds until the page is closed.
    }
  }
}

/** Whatever was stored, by whichever version: unknown or ill-typed parts fall back to the defaults. */
function read(store: Store | null): Settings {
  try {
    const stored = JSON.parse(store?.getItem(KEY) ?? '{}') as Partial<Record<keyof Settings, unknown>>;
    return {
      theme: stored.theme === 'light' ? 'light' : DEFAULT_SETTINGS.theme,
      penOnly: stored.penOnly === true,
      singleKeys: stored.singleKeys !== false,
      keys: keysOf(stored.keys),
    };
  } catch {
    return DEFAULT_SETTINGS;
  }
}

function keysOf(stored: unknown): Settings['keys'] {
  if (stored === null || typeof stored !== 'object') return {};
  const usable = Object.entries(stored).filter(
    ([, keys]) => Array.isArray(keys) && keys.every((key) => typeof key === 'string'),
  );
  return Object.fromEntries(usable);
}
