// Key presses as text, `Mod+Shift+Z`, and who owns them. No DOM beyond the fields of an event.

export interface KeyPress {
  readonly key: string;
  readonly code: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly altKey: boolean;
  readonly shiftKey: boolean;
}

/** What the rule needs to know of the focused element. */
export interface Focused {
  readonly tagName: string;
  readonly type?: string;
  readonly isContentEditable?: boolean;
}

const MODIFIERS = new Set(['Control', 'Meta', 'Alt', 'Shift', 'AltGraph', 'CapsLock', 'Fn', 'Dead']);

/**
 * The shortcut a key press stands for, `null` for a bare modifier. `Mod` is Cmd on a Mac, Ctrl elsewhere.
 * Letters go by what is printed on the key; signs that need Shift (`?`) are written without it.
 */
export function keyOf(press: KeyPress, mac: boolean): string | null {
  if (MODIFIERS.has(press.key)) return null;
  // Alt changes what a key types on some systems; then the place of the key counts.
  const place = /^(?:Key([A-Z])|Digit(\d))$/.exec(press.code);
  const typed = press.altKey && place ? (place[1] ?? place[2])! : press.key;
  const isSign = typed.length === 1 && typed.toUpperCase() === typed.toLowerCase();
  const name = typed === ' ' ? 'Space' : typed.length === 1 ? typed.toUpperCase() : typed;
  const parts = [
    (mac ? press.metaKey : press.ctrlKey) && 'Mod',
    (mac ? press.ctrlKey : press.metaKey) && 'Meta',
    press.altKey && 'Alt',
    press.shiftKey && (!isSign || typed === ' ') && 'Shift',
    name,
  ];
  return parts.filter(Boolean).join('+');
}

const TYPES_THAT_TAKE_TEXT = new Set(
  'text search number url email password tel date time datetime-local month week'.split(' '),
);
const CONTROLS = new Set(['BUTTON', 'A', 'INPUT', 'SELECT', 'SUMMARY', 'LI', 'DIV', 'SPAN']);
const CONTROL_KEYS = /^(Enter|Space|Tab|Arrow\w+|Home|End|Page\w+)$/;

/**
 * Whether the focused element keeps a key press for itself: text inputs own every key; other controls own
 * Enter, Space, Tab, arrows, Home, End and Page; the page's body and the viewport own none.
 */
export function ownsKey(focused: Focused | null, key: string): boolean {
  if (!focused) return false;
  if (focused.isContentEditable || focused.tagName === 'TEXTAREA') return true;
  if (focused.tagName === 'INPUT' && TYPES_THAT_TAKE_TEXT.has(focused.type ?? 'text')) return true;
  return CONTROLS.has(focused.tagName) && CONTROL_KEYS.test(key.replace('Shift+', ''));
}

/** Whether it is one character without Mod, Meta or Alt: may be switched off (WCAG 2.1.4). */
export const isSingleKey = (key: string): boolean => /^(Shift\+)?.$/u.test(key);

const MAC: Record<string, string> = { Mod: '⌘', Meta: '⌃', Alt: '⌥', Shift: '⇧' };
const SIGNS: Record<string, string> = {
  ArrowUp: '↑',
  ArrowDown: '↓',
  ArrowLeft: '←',
  ArrowRight: '→',
  Escape: 'Esc',
};

/** A shortcut as this system writes it: `Ctrl+Shift+Z` or `⇧⌘Z`. */
export function keyLabel(key: string, mac: boolean): string {
  const parts = key.endsWith('++')
    ? [...key.slice(0, -2).split('+'), '+']
    : key === '+'
      ? ['+']
      : key.split('+');
  const sign = SIGNS[parts.at(-1)!] ?? parts.at(-1)!;
  const modifiers = parts.slice(0, -1);
  if (!mac) return [...modifiers.map((m) => (m === 'Mod' ? 'Ctrl' : m)), sign].join('+');
  const order = ['Meta', 'Alt', 'Shift', 'Mod'];
  return (
    order
      .filter((m) => modifiers.includes(m))
      .map((m) => MAC[m])
      .join('') + sign
  );
}
