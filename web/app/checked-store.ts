// What comes out of the browser's store is checked before it is trusted: another version, a browser's fault or a person
// with its tools may have written it.

import * as v from 'valibot';
import type { DocumentStore, StoredDocument } from './store';

const whole = v.pipe(v.number(), v.integer(), v.minValue(0));

/** Earlier versions say `handle` for any item. */
const item = v.exactOptional(v.nullable(whole));
const selection = v.looseObject({ step: v.string(), item, handle: item });

const storedDocument = v.looseObject({
  id: v.string(),
  revision: v.exactOptional(whole),
  time: v.number(),
  title: v.string(),
  kind: v.picklist(['auto', 'kept']),
  link: v.exactOptional(v.string()),
  entries: v.array(v.looseObject({ recipe: v.string(), selection, label: v.string(), time: v.number() })),
  index: whole,
  files: v.array(v.looseObject({ file: v.string(), hash: v.string() })),
  steps: v.number(),
  handles: v.number(),
});

const isSound = (value: unknown): value is StoredDocument => v.is(storedDocument, value);

/**
 * The store without the documents that are none.
 *
 * @param onDamaged  told the first time that one was passed over
 */
export function checkedStore(store: DocumentStore, onDamaged: () => void): DocumentStore {
  let told = false;
  const sound = (documents: readonly (StoredDocument | undefined)[]): StoredDocument[] => {
    const kept = documents.filter(isSound);
    if (kept.length < documents.length && !told) {
      told = true;
      onDamaged();
    }
    return kept;
  };
  return {
    documents: async () => sound(await store.documents()),
    document: async (id) => {
      const found = await store.document(id);
      return found && sound([found])[0];
    },
    blob: (hash) => store.blob(hash),
    write: (document, blobs, onlyNewer) => store.write(document, blobs, onlyNewer),
    remove: (ids) => store.remove(ids),
  };
}
