// Documents in the browser's store: what was kept is changed, then a tab takes it up again.

import type { StoredDocument } from '../../../web/app/store';
import { Browser, Tab } from '../../app/world';
import { type Generator, must, outcomeOf } from '../generator';
import { mutateBytes, mutateJson, tweakJson } from '../mutate';

let kept:
  | Promise<{ readonly document: StoredDocument; readonly blobs: ReadonlyMap<string, Uint8Array> }>
  | undefined;

/** A cube with two handles, one of them undone. */
async function keep() {
  const tab = new Tab();
  await tab.openCube();
  await tab.addHandle([0, 1], 'Low');
  await tab.addHandle([6, 7], 'High');
  tab.app.document.undo();
  await tab.app.autosave.flush();
  const [document] = tab.browser.store.kept.values();
  return { document: document!, blobs: new Map(tab.browser.store.blobs) };
}

const stored: Generator = {
  kind: 'stored document',
  every: 5,
  async run(random) {
    kept ??= keep();
    const { document, blobs } = await kept;
    const browser = new Browser();
    const changed = random.chance(0.5)
      ? tweakJson(random, document)
      : mutateJson(random, document, 1 + random.few(2));
    browser.store.kept.set(document.id, changed as StoredDocument);
    for (const [hash, bytes] of blobs) {
      if (random.chance(0.05)) continue;
      browser.store.blobs.set(hash, random.chance(0.2) ? mutateBytes(random, bytes) : bytes);
    }
    const tab = new Tab(browser);
    const failures: unknown[] = [];
    Object.assign(tab.app.messages, { failed: (error: unknown) => failures.push(error) });
    try {
      const restored = await tab.app.autosave.restoreLast();
      await tab.app.evaluator.settled();
      if (restored && tab.deform.step) {
        await tab.addHandle([2], 'Again');
        await tab.app.autosave.flush();
        must(tab.app.state.saved.value.kind !== 'failed', `${JSON.stringify(tab.app.state.saved.value)}`);
      }
      for (const error of failures) {
        const outcome = await outcomeOf(() => Promise.reject(error));
        if (outcome !== 'accepted') return outcome;
      }
      return restored ? 'accepted' : 'nothing restored';
    } finally {
      tab.close();
    }
  },
};
export default stored;
