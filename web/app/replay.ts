// What a journal entry makes of the document in the store: the history that was written, and the newest state.

import { parseRecipe } from '../recipe/parse';
import type { Recipe } from '../recipe/recipe';
import type { JournalEntry } from './journal';
import { hashedText } from './recipe-text';
import type { StoredDocument, StoredEntry } from './store';

/** A document with those of its blobs that the store may not have. */
export interface KeptDocument {
  readonly document: StoredDocument;
  readonly blobs: ReadonlyMap<string, Uint8Array>;
}

/** @param stored  the document as the store has it, older than the entry; `undefined` where it has none */
export async function replayed(entry: JournalEntry, stored?: StoredDocument): Promise<KeptDocument> {
  const recipe = parseRecipe(entry.recipe);
  const { hash, bytes } = await hashedText(recipe);
  const { id, revision, title, link, files, selection, label, time, after } = entry;
  const state: StoredEntry = { recipe: hash, selection, label, time };
  const history = stored?.entries ?? [];
  // An undo or a redo leads to a state that the history has; anything else is put behind the one it came from.
  const known = history.findLastIndex((each) => each.recipe === hash && isSame(each, state));
  const found = after ? history.findLastIndex((each) => isSame(each, after)) : -1;
  const before = found >= 0 || !after ? found : (stored?.index ?? -1);
  const entries = known >= 0 ? history : [...history.slice(0, before + 1), state];
  const document: StoredDocument = {
    id,
    revision,
    time: Math.max(time, stored?.time ?? 0),
    title,
    kind: 'auto',
    ...(link !== undefined && { link }),
    entries,
    index: known >= 0 ? known : entries.length - 1,
    files: [...new Map([...(stored?.files ?? []), ...files].map((each) => [each.file, each])).values()],
    ...countsOf(recipe),
  };
  return { document, blobs: new Map([[hash, bytes]]) };
}

/** What the list of restore points says of a document. */
export const countsOf = ({ steps }: Recipe): Pick<StoredDocument, 'steps' | 'handles'> => ({
  steps: steps.length,
  handles: steps.reduce((sum, step) => sum + ('handles' in step ? step.handles.length : 0), 0),
});

const isSame = (a: Pick<StoredEntry, 'label' | 'time'>, b: Pick<StoredEntry, 'label' | 'time'>): boolean =>
  a.label === b.label && a.time === b.time;
