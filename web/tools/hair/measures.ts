// Lengths of the hair tools, as parts of the head's height; a head of any unit is drawn on alike.

import { placesFor } from '../stroke/polyline';

/** Between two control points of a stream. */
export const SPACING = 1 / 18;
/** A parting is short and lies on the skin. */
export const PARTING_SPACING = 1 / 30;
/** Strokes shorter than this are slips of the hand. */
export const SHORTEST = 1 / 20;
/** How far a supporting surface reaches to either side of its curve. */
export const REACH = 0.22;
/** With the mirror on, what lies nearer to x = 0 than this everywhere lies on it, and has no mirror image. */
export const MIDDLE = 0.03;
/** A ponytail is drawn from the side, where the head curves away: it is on the middle from further off. */
export const MIDDLE_TAIL = 0.13;

/** Decimals of stored points. */
export const places = (height: number): number => placesFor(height);

/** CSS pixels within which a hint stroke's end counts as near to a curve. */
export const nearness = (pointer: 'mouse' | 'pen' | 'touch'): number => (pointer === 'touch' ? 26 : 16);
