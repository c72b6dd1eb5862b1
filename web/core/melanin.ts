// The colour of hair from its two melanins, as a person would pick it: how much, and how much of it is the red kind.

/** Hair of little and much melanin, sRGB; brown-black and red. */
const DARK = ['#efe6d2', '#d9b27c', '#a9743f', '#6b4226', '#38200f', '#0d0a09'] as const;
const RED = ['#f0dfc4', '#e3a45c', '#c9682a', '#963c18', '#571d10', '#120907'] as const;

/**
 * @param melanin  0 white … 1 black
 * @param redness  0 … 1
 * @returns `#rrggbb`
 */
export function hairColor(melanin: number, redness: number): string {
  const at = Math.min(1, Math.max(0, melanin)) * (DARK.length - 1);
  const low = Math.min(DARK.length - 2, Math.floor(at));
  const channel = (colors: readonly string[], k: number): number => {
    const value = (i: number) => Number.parseInt(colors[i]!.slice(1 + 2 * k, 3 + 2 * k), 16);
    return value(low) + (at - low) * (value(low + 1) - value(low));
  };
  const mixed = [0, 1, 2].map((k) => (1 - redness) * channel(DARK, k) + redness * channel(RED, k));
  return `#${mixed.map((c) => Math.round(c).toString(16).padStart(2, '0')).join('')}`;
}
