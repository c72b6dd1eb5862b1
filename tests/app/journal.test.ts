// What is there again after a tab went without a word: `close` writes nothing, as a crash does.

import { afterEach, expect, test, vi } from 'vitest';
import { LONGEST_DELAY } from '../../web/app/autosave';
import { type Browser, Tab } from './world';

afterEach(() => vi.useRealTimers());

const journalOf = ({ storage }: Browser) =>
  Array.from({ length: storage.length }, (_, i) => storage.key(i)!).filter((key) => key.includes('journal'));

/** A cube with one handle, all of it in the store. */
async function edited(tab = new Tab()): Promise<Tab> {
  await tab.openCube();
  await tab.addHandle([0, 1], 'Low');
  await tab.app.autosave.flush();
  return tab;
}

const move = (tab: Tab, x: number) => tab.deform.setPose(0, { translation: [x, 0, 0] });

/** The tab is gone, and opened again. */
async function again(tab: Tab): Promise<Tab> {
  const next = tab.reloaded();
  expect(await next.app.autosave.restoreLast()).toBe(true);
  await next.app.evaluator.settled();
  return next;
}

test('an edit is there again although the tab went in the same moment', async () => {
  const tab = await edited();
  move(tab, 5);
  const next = await again(tab);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
  expect(next.app.evaluator.result.value?.positions[0]).toBe(5);
  next.app.document.undo();
  expect(next.app.document.recipe.steps[0]).toMatchObject({ handles: [{ name: 'Low' }] });
  expect(next.app.state.canUndo.value).toBe(true);
});

test('the journal has nothing that the store has, and the store all that the journal had', async () => {
  const tab = await edited();
  expect(journalOf(tab.browser)).toHaveLength(0);
  move(tab, 5);
  expect(journalOf(tab.browser)).toHaveLength(1);
  const { written } = tab.browser.store;
  const next = await again(tab);
  expect(journalOf(tab.browser)).toHaveLength(0);
  expect(tab.browser.store.written).toBe(written + 1);
  expect(next.app.state.saved.value.kind).toBe('saved');
});

test('an undo is there again, and what it took back can be redone', async () => {
  const tab = await edited();
  move(tab, 5);
  await tab.app.autosave.flush();
  tab.app.document.undo();
  const next = await again(tab);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
  next.app.document.redo();
  await next.app.evaluator.settled();
  expect(next.app.evaluator.result.value?.positions[0]).toBe(5);
});

test('an edit in place of what was undone cuts it off, as it did before the tab went', async () => {
  const tab = await edited();
  move(tab, 5);
  await tab.app.autosave.flush();
  tab.app.document.undo();
  move(tab, 7);
  const labels = tab.app.document.entries.map(({ label }) => label);
  const next = await again(tab);
  expect(next.app.document.entries.map(({ label }) => label)).toEqual(labels);
  expect(next.app.state.canRedo.value).toBe(false);
});

test('the first edit of all is there again, the store having nothing yet', async () => {
  const tab = new Tab();
  await tab.openCube();
  await tab.app.autosave.flush();
  tab.browser.store.kept.clear();
  await tab.addHandle([0, 1], 'Low');
  const next = await again(tab);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
});

test('minus zero stays minus zero', async () => {
  const tab = await edited();
  move(tab, -0);
  const { steps } = (await again(tab)).app.document.recipe;
  expect(steps).toEqual(tab.app.document.recipe.steps);
});

test('edits that never pause are written all the same', async () => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  const tab = await edited();
  const { store } = tab.browser;
  const revisions = () => [...store.kept.values()].map(({ revision }) => revision!);
  let unsavedFor = 0;
  for (let i = 0; i < 400; i++) {
    move(tab, i);
    vi.advanceTimersByTime(900);
    unsavedFor += 900;
    // The digests come from outside: nothing but real time brings them.
    while (tab.app.state.saved.value.kind === 'saving') await new Promise(setImmediate);
    if (revisions()[0]! >= tab.app.autosave.revision - 1) unsavedFor = 900;
    expect(unsavedFor).toBeLessThanOrEqual(LONGEST_DELAY + 900);
  }
  expect(revisions()[0]).toBeGreaterThanOrEqual(tab.app.autosave.revision - 2);
});

test('a store that is full loses no edit, and has all of them as soon as it has room', async () => {
  const tab = await edited();
  tab.browser.store.broken = true;
  move(tab, 5);
  await tab.app.autosave.flush();
  const next = await again(tab);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
  move(next, 6);
  const last = await again(next);
  expect(last.app.document.recipe).toEqual(next.app.document.recipe);
  tab.browser.store.broken = false;
  await last.app.autosave.flush();
  expect(last.app.state.saved.value.kind).toBe('saved');
  expect(journalOf(tab.browser)).toHaveLength(0);
  expect((await again(last)).app.document.recipe).toEqual(next.app.document.recipe);
});

test('a store that does not answer keeps no one from the last edit, and is not written over', async () => {
  const tab = await edited();
  const { store } = tab.browser;
  const before = structuredClone(store.kept);
  move(tab, 5);
  store.silent = true;
  const next = await again(tab);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
  expect(next.toasts.some((text) => text.includes('no answer'))).toBe(true);
  store.silent = false;
  await next.app.autosave.flush();
  for (const [id, document] of before) expect(store.kept.get(id)).toEqual(document);
  expect(store.kept.size).toBe(before.size + 1);
  expect((await again(next)).app.document.recipe).toEqual(tab.app.document.recipe);
});

test('files that a silent store does not give are back as soon as it answers', async () => {
  const tab = await edited();
  move(tab, 5);
  const { store } = tab.browser;
  store.silent = true;
  const next = await again(tab);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
  expect(next.app.evaluator.result.value).toBeNull();
  expect(next.toasts.some((text) => text.includes('Until it does, files are missing: cube.obj'))).toBe(true);
  store.silent = false;
  await next.app.autosave.flush();
  await next.app.evaluator.settled();
  expect(next.app.evaluator.result.value?.positions[0]).toBe(5);
  const last = await again(next);
  expect(last.app.evaluator.result.value?.positions[0]).toBe(5);
});

test('a file that was missing once is still known to be missing after the next save', async () => {
  const tab = await edited();
  const [document] = tab.browser.store.kept.values();
  const [{ hash } = { hash: '' }] = document!.files;
  const bytes = tab.browser.store.blobs.get(hash)!;
  tab.browser.store.blobs.delete(hash);
  const next = tab.reloaded();
  await next.app.autosave.restoreLast();
  next.app.document.undo();
  await next.app.autosave.flush();
  tab.browser.store.blobs.set(hash, bytes);
  const last = await again(next);
  expect(last.app.evaluator.result.value?.positions).toHaveLength(24);
});

test('where the journal has no room the store is written at once', async () => {
  const tab = await edited();
  tab.browser.storage.full = true;
  move(tab, 5);
  await vi.waitFor(() => expect(tab.app.state.saved.value.kind).toBe('saved'), {
    timeout: 900,
    interval: 20,
  });
  expect((await again(tab)).app.document.recipe).toEqual(tab.app.document.recipe);
});

test('an edit is at risk only while neither journal nor store has it', async () => {
  const tab = await edited();
  const { storage, store } = tab.browser;
  const { autosave } = tab.app;
  move(tab, 5);
  expect(autosave.isAtRisk).toBe(false);
  storage.full = true;
  move(tab, 6);
  expect(autosave.isAtRisk).toBe(true);
  await autosave.flush();
  expect(autosave.isAtRisk).toBe(false);
  store.broken = true;
  move(tab, 7);
  await autosave.flush();
  expect(autosave.isAtRisk).toBe(true);
  // With room again the last word of a page that is left is enough.
  storage.full = false;
  autosave.lastWord();
  expect(autosave.isAtRisk).toBe(false);
  expect((await again(tab)).app.document.recipe).toEqual(tab.app.document.recipe);
});

test('a file of one’s own is in the store at once: the journal cannot hold it', async () => {
  const tab = new Tab();
  await tab.openCube();
  await vi.waitFor(() => expect(tab.browser.store.kept.size).toBe(1), { timeout: 900, interval: 20 });
});

test('a tab that comes back has its work although another is just taking up what it left', async () => {
  const tab = await edited();
  move(tab, 5);
  tab.close();
  const { store } = tab.browser;
  const write = store.write.bind(store);
  let goOn = () => {};
  store.write = async (...args) => {
    store.write = write;
    await new Promise<void>((done) => {
      goOn = done;
    });
    return write(...args);
  };
  const other = new Tab(tab.browser);
  const restoring = other.app.autosave.restoreLast();
  await vi.waitFor(() => expect(store.write).toBe(write));
  const next = await again(tab);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
  move(next, 6);
  await next.app.autosave.flush();
  // What the other one has begun is old by now, and the document taken.
  goOn();
  expect(await restoring).toBe(false);
  expect((await again(next)).app.document.recipe).toEqual(next.app.document.recipe);
});

test('a tab that comes back has its work although another took it up while the store was being read', async () => {
  const tab = await edited();
  move(tab, 5);
  const { store } = tab.browser;
  const next = tab.reloaded();
  const other = new Tab(tab.browser);
  const read = store.documents;
  // The list is read before the other tab writes, and handed over after it.
  store.documents = async () => {
    store.documents = read;
    const early = (await read()).map((each) => structuredClone(each));
    await other.app.autosave.restorePoints();
    return early;
  };
  expect(await next.app.autosave.restoreLast()).toBe(true);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
});

test('a tab that is reloaded waits for its last page to go, and has what that wrote last', async () => {
  const tab = await edited();
  move(tab, 5);
  const next = tab.comingBack();
  tab.browser.afterPatience = () => {
    move(tab, 6);
    tab.close();
  };
  expect(await next.app.autosave.restoreLast()).toBe(true);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
  expect((await again(next)).app.document.recipe).toEqual(tab.app.document.recipe);
});

test('a tab that was duplicated does not wait, and leaves the other its document', async () => {
  const tab = await edited();
  const copy = new Tab(tab.browser, tab.session);
  tab.browser.afterPatience = () => expect.unreachable();
  expect(await copy.app.autosave.restoreLast()).toBe(false);
});

test('a restore point that another tab wrote last is opened as that tab left it', async () => {
  const tab = await edited();
  const here = new Tab(tab.browser);
  await here.openCube();
  const point = (await here.app.autosave.restorePoints()).find(({ current }) => !current);
  move(tab, 5);
  tab.close();
  await here.app.autosave.restore(point!.id);
  expect(here.app.document.recipe).toEqual(tab.app.document.recipe);
});

test('what a living tab has in the journal is its own', async () => {
  const tab = await edited();
  move(tab, 5);
  const other = new Tab(tab.browser);
  expect(await other.app.autosave.restoreLast()).toBe(false);
  expect(journalOf(tab.browser)).toHaveLength(1);
});

test('a tab whose document turns out to be another’s goes on with a copy', async () => {
  const tab = await edited();
  const [id] = tab.browser.store.kept.keys();
  tab.lose(id!);
  move(tab, 5);
  await tab.app.autosave.flush();
  const steps = [...tab.browser.store.kept.values()].map(({ entries }) => entries.length);
  expect(steps).toEqual([2, 3]);
});

test('a file that the browser no longer has is named, and the work is there without it', async () => {
  const tab = await edited();
  const [document] = tab.browser.store.kept.values();
  for (const { hash } of document!.files) tab.browser.store.blobs.delete(hash);
  const next = tab.reloaded();
  expect(await next.app.autosave.restoreLast()).toBe(true);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
  expect(next.toasts).toContain(
    '“cube” is back, but this browser no longer has its files: cube.obj. Save the project and open it together with them.',
  );
});

test('states of the history that are gone are counted, and the one shown stays the one shown', async () => {
  const tab = await edited();
  move(tab, 5);
  await tab.app.autosave.flush();
  const [document] = tab.browser.store.kept.values();
  tab.browser.store.blobs.delete(document!.entries[1]!.recipe);
  const next = await again(tab);
  expect(next.app.document.recipe).toEqual(tab.app.document.recipe);
  expect(next.app.document.entries).toHaveLength(document!.entries.length - 1);
  expect(next.toasts.some((text) => text.includes('no longer has 1 state of its undo history'))).toBe(true);
});

test('work of which nothing is left is said to be gone, once', async () => {
  const tab = await edited();
  for (const { recipe } of [...tab.browser.store.kept.values()][0]!.entries)
    tab.browser.store.blobs.delete(recipe);
  const next = tab.reloaded();
  expect(await next.app.autosave.restoreLast()).toBe(false);
  expect(next.toasts).toEqual([
    '“cube” could not be brought back: this browser no longer has what was kept of it.',
  ]);
  expect(tab.browser.store.kept.size).toBe(0);
});
