// The viewport's colours: LOOK's tokens, and the few tones only a picture needs.

/**
 * Tints of what is marked on a model, for every purpose alike. Where marked regions overlap, later ones lie over earlier;
 * the first two are for large areas and are paler.
 */
export const TINTS = ['blue', 'green', 'azure', 'red', 'yellow', 'violet'] as const;
export type Tint = (typeof TINTS)[number];
export const LARGE: ReadonlySet<Tint> = new Set(['blue', 'green']);

export interface Palette {
  readonly exposure: number;
  /** Background gradient, top to bottom. */
  readonly sky: string;
  readonly floor: string;
  readonly grid: string;
  /** Strength of the grid's lines and of the shadows on the ground, 0–1. */
  readonly gridStrength: number;
  readonly shadowStrength: number;
  readonly wire: string;
  readonly wireStrength: number;
  /** A drawing with a pen: the sheet from top to bottom; the model on it, and where that turns away; the lines. */
  readonly sheet: readonly [string, string];
  readonly paper: string;
  readonly paperEdge: string;
  readonly ink: string;
  readonly panel: string;
  readonly warn: string;
  readonly tints: Readonly<Record<Tint, string>>;
  /** x, y, z. */
  readonly axes: readonly [string, string, string];
}

export const CLAY = '#c9b9a8';
/** The inside of an open surface. */
export const INTERIOR = '#7d4438';

export const PALETTES: Readonly<Record<'dark' | 'light', Palette>> = {
  dark: {
    exposure: 1.05,
    sky: '#1a1d21',
    floor: '#3c424b',
    grid: '#98a2ae',
    gridStrength: 0.2,
    shadowStrength: 0.62,
    wire: '#14161a',
    wireStrength: 0.42,
    sheet: ['#5f5c57', '#7a766f'],
    paper: '#e0dcd4',
    paperEdge: '#b7b3aa',
    ink: '#141517',
    panel: '#1d2025',
    warn: '#f0a843',
    tints: {
      blue: '#4f8cff',
      violet: '#a566ff',
      red: '#e5534b',
      yellow: '#e3b341',
      azure: '#4f8cff',
      green: '#4cc38a',
    },
    axes: ['#e8636b', '#7fbf5a', '#5b93f5'],
  },
  light: {
    exposure: 1.2,
    sky: '#dfe3e8',
    floor: '#f4f5f7',
    grid: '#5b6672',
    gridStrength: 0.26,
    shadowStrength: 0.4,
    wire: '#1b1f24',
    wireStrength: 0.4,
    sheet: ['#e9e7e2', '#f3f1ed'],
    paper: '#fdfcfa',
    paperEdge: '#e3e1dc',
    ink: '#1f242a',
    panel: '#ffffff',
    warn: '#b36b00',
    tints: {
      blue: '#2f6fe4',
      violet: '#8640e6',
      red: '#ce4b44',
      yellow: '#cca13b',
      azure: '#477ee6',
      green: '#1f9d63',
    },
    axes: ['#d2434c', '#4f9130', '#3a70dc'],
  },
};
