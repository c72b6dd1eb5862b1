// Files that hold something beside a model, or no model at all: they can be looked at, and are no document.

import { isHair } from './strands/hair';
import { hasObjLines } from './strands/obj-lines';

export type LooseKind = 'strands';

/** Files of these endings hold no model. */
export const LOOSE_ENDINGS: readonly string[] = ['.hair'];

/** What a file holds beside a model, as its first bytes and its name tell; `only`: it holds no model at all. */
export function looseKind(
  bytes: Uint8Array,
  name: string,
): { readonly kind: LooseKind; readonly only: boolean } | undefined {
  const ends = (ending: string) => name.toLowerCase().endsWith(ending);
  if (isHair(bytes) || LOOSE_ENDINGS.some(ends)) return { kind: 'strands', only: true };
  if (ends('.obj') && hasObjLines(bytes)) return { kind: 'strands', only: false };
  return undefined;
}
