// Files that are no document: they can be looked at beside what is open, by the wing that knows their kind.

import { isHair } from '../io/strands/hair';
import { hasObjLines } from '../io/strands/obj-lines';

export type LooseKind = 'strands';

/** What a file is beside a model, as its first bytes and its name tell; `only`: it holds no model at all. */
export function looseKind(
  bytes: Uint8Array,
  name: string,
): { readonly kind: LooseKind; readonly only: boolean } | undefined {
  const ends = (ending: string) => name.toLowerCase().endsWith(ending);
  if (isHair(bytes) || ends('.hair')) return { kind: 'strands', only: true };
  if (ends('.obj') && hasObjLines(bytes)) return { kind: 'strands', only: false };
  return undefined;
}
