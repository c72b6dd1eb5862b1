import { describe, expect, test } from 'vitest';
import { isSingleKey, type KeyPress, keyLabel, keyOf, ownsKey } from '../../web/app/keys';
import { DEFAULT_SETTINGS, StoredSettings } from '../../web/app/settings';
import { WORKSPACES } from '../../web/app/wings';
import { MemoryStorage, Tab } from './world';

const press = (key: string, how: Partial<KeyPress> = {}): KeyPress => ({
  key,
  code: '',
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  shiftKey: false,
  ...how,
});

describe('who owns a key', () => {
  const text = { tagName: 'INPUT', type: 'text' };
  const button = { tagName: 'BUTTON' };
  test.each(['A', 'Mod+Z', 'Delete', 'Enter', 'Escape'])('a text input owns %s', (key) => {
    expect(ownsKey(text, key)).toBe(true);
  });
  test.each(['Enter', 'Space', 'Tab', 'Shift+Tab', 'ArrowUp', 'Home', 'End', 'PageDown'])(
    'a button owns %s',
    (key) => {
      expect(ownsKey(button, key)).toBe(true);
    },
  );
  test.each(['B', 'Mod+Z', 'Delete', 'Escape', '['])('a button lets %s through', (key) => {
    expect(ownsKey(button, key)).toBe(false);
  });
  test('a slider lets letters through', () => {
    expect(ownsKey({ tagName: 'INPUT', type: 'range' }, 'W')).toBe(false);
    expect(ownsKey({ tagName: 'INPUT', type: 'range' }, 'ArrowLeft')).toBe(true);
  });
  test('the page itself owns nothing', () => {
    expect(ownsKey(null, 'Enter')).toBe(false);
  });
});

describe('a key press as text', () => {
  test.each([
    [press('z', { ctrlKey: true }), false, 'Mod+Z'],
    [press('Z', { ctrlKey: true, shiftKey: true }), false, 'Mod+Shift+Z'],
    [press('z', { metaKey: true }), true, 'Mod+Z'],
    [press('?', { shiftKey: true }), false, '?'],
    [press('[', { altKey: false }), false, '['],
    [press('ß', { altKey: true, code: 'KeyS' }), true, 'Alt+S'],
    [press(' '), false, 'Space'],
    [press('Delete'), false, 'Delete'],
  ])('%o is written %s', (event, mac, text) => {
    expect(keyOf(event, mac)).toBe(text);
  });
  test('a bare modifier is no shortcut', () => {
    expect(keyOf(press('Shift', { shiftKey: true }), false)).toBeNull();
  });
  test('labels are those of the system', () => {
    expect(keyLabel('Mod+Shift+Z', false)).toBe('Ctrl+Shift+Z');
    expect(keyLabel('Mod+Shift+Z', true)).toBe('⇧⌘Z');
  });
  test('single keys are those of one character', () => {
    expect(['B', '[', '?', 'Shift+A'].every(isSingleKey)).toBe(true);
    expect(['Mod+B', 'Delete', 'F1', 'Escape'].some(isSingleKey)).toBe(false);
  });
});

describe('the keymap', () => {
  test('in no workspace does a shortcut have two owners', async () => {
    const { commands, wings } = new Tab().app;
    await wings.loadAll();
    for (const place of WORKSPACES) {
      const here = commands.all.filter(({ workspace = place }) => workspace === place);
      const keys = here.flatMap(({ keys }) => keys ?? []);
      expect(new Set(keys).size).toBe(keys.length);
    }
  });

  test('what is remapped is remembered, and whoever had the key loses it', async () => {
    const tab = new Tab();
    await tab.app.wings.loadAll();
    tab.app.keymap.rebind('view.grid', ['B']);
    expect(tab.app.keymap.ownerOf('B')).toBe('view.grid');
    expect(tab.app.keymap.keys('tool.paint-roi')).toEqual([]);
    const again = tab.reloaded();
    await again.app.wings.loadAll();
    expect(again.app.keymap.ownerOf('B')).toBe('view.grid');
    again.app.keymap.resetAll();
    expect(again.app.keymap.ownerOf('B')).toBe('tool.paint-roi');
  });

  test('single keys can be switched off; the others stay', async () => {
    const tab = new Tab();
    await tab.openCube();
    expect(tab.app.keymap.commandFor(press('b'), null)).toBe('tool.paint-roi');
    tab.app.settings.update({ singleKeys: false });
    expect(tab.app.keymap.commandFor(press('b'), null)).toBeNull();
    expect(tab.app.keymap.commandFor(press('k', { ctrlKey: true }), null)).toBe('help.palette');
    expect(tab.app.keymap.hint('tool.paint-roi')).toBe('');
  });

  test('a disabled command leaves its key alone', () => {
    expect(new Tab().app.keymap.commandFor(press('z', { ctrlKey: true }), null)).toBeNull();
  });
});

test('settings of any past or damaged form fall back to the defaults', () => {
  for (const stored of ['', 'null', '7', '{"theme":3,"keys":{"a":1,"b":["X"]}}', '{']) {
    const storage = new MemoryStorage();
    storage.setItem('lissom.settings', stored);
    const { keys, ...rest } = new StoredSettings(storage).values.value;
    expect({ ...DEFAULT_SETTINGS, keys: {} }).toEqual({ ...rest, keys: {} });
    expect(Object.keys(keys).every((key) => key === 'b')).toBe(true);
  }
});
