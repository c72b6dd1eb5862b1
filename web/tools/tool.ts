import type { PointerHandler, PointerSample } from '../view/types';

/** A small state machine over pointer samples. It reads the scene and offers edits; it keeps no document. */
export type Tool = PointerHandler;

/** How far a press may wander and still be a click, in CSS pixels. */
export const clickSlop = (pointer: PointerSample['pointerType']): number => (pointer === 'mouse' ? 3 : 8);

export const distance = (a: PointerSample, b: PointerSample): number => Math.hypot(a.x - b.x, a.y - b.y);
