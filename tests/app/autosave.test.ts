import { expect, test } from 'vitest';
import { MOST_RESTORE_POINTS } from '../../web/app/autosave';
import { type StoredDocument, selectionOf } from '../../web/app/store';
import { Browser, Tab } from './world';

async function edited(tab = new Tab()): Promise<Tab> {
  await tab.openCube();
  await tab.addHandle([0, 1], 'Low');
  tab.deform.setPose(0, { translation: [5, 0, 0] });
  await tab.app.autosave.flush();
  return tab;
}

test('after a reload the work is back, with its undo history and the file it was made on', async () => {
  const tab = await edited();
  const again = tab.reloaded();
  expect(await again.app.autosave.restoreLast()).toBe(true);
  await again.app.evaluator.settled();
  expect(again.app.document.recipe).toEqual(tab.app.document.recipe);
  expect(again.app.evaluator.result.value?.positions[0]).toBe(5);
  expect(again.app.state.undoLabel.value).toBe('Place Low');
  again.app.document.undo();
  await again.app.evaluator.settled();
  expect(again.app.evaluator.result.value?.positions[0]).toBe(0);
});

test('undone work can be redone after a reload', async () => {
  const tab = await edited();
  tab.app.document.undo();
  await tab.app.autosave.flush();
  const again = tab.reloaded();
  await again.app.autosave.restoreLast();
  expect(again.app.state.canRedo.value).toBe(true);
});

test('a model of one’s own is kept before the first edit', async () => {
  const tab = new Tab();
  await tab.openCube();
  await tab.app.autosave.flush();
  expect(tab.browser.store.kept.size).toBe(1);
});

test('an edit writes what is new and nothing else', async () => {
  const tab = await edited();
  const { written } = tab.browser.store;
  tab.deform.setMethod('naive');
  await tab.app.autosave.flush();
  expect(tab.browser.store.written).toBe(written + 1);
});

test('another document sets the last one aside as a restore point', async () => {
  const tab = await edited();
  const before = tab.app.document.recipe;
  await tab.openCube();
  const points = await tab.app.autosave.restorePoints();
  expect(points.map(({ kind, current }) => [kind, current])).toEqual([
    ['auto', true],
    ['kept', false],
  ]);
  expect(tab.toasts).toContain('What you had is kept under Restore points.');
  await tab.app.autosave.restore(points[1]!.id);
  expect(tab.app.document.recipe).toEqual(before);
});

test('two tabs never write over each other', async () => {
  const browser = new Browser();
  const first = await edited(new Tab(browser));
  const second = new Tab(browser, first.session);
  // Opened as a copy of the first, with the same session storage: it gets a restore point of its own.
  const [point] = await second.app.autosave.restorePoints();
  await second.app.autosave.restore(point!.id);
  await second.app.evaluator.settled();
  second.deform.setPose(0, { translation: [9, 0, 0] });
  await second.app.autosave.flush();
  expect(browser.store.kept.size).toBe(2);
  const again = first.reloaded();
  await again.app.autosave.restore(point!.id);
  await again.app.evaluator.settled();
  expect(again.deform.step?.handles[0]).toMatchObject({
    matrix: expect.arrayContaining([5]),
  });
});

test('a new tab takes over what a closed one left, never what a living one has', async () => {
  const browser = new Browser();
  const first = await edited(new Tab(browser));
  const second = new Tab(browser);
  expect(await second.app.autosave.restoreLast()).toBe(false);
  first.close();
  const third = new Tab(browser);
  expect(await third.app.autosave.restoreLast()).toBe(true);
});

test('the address has the link of the document that is open, and no other one’s', async () => {
  const tab = new Tab();
  await tab.openCube();
  const { recipe } = tab.app.document;
  await tab.app.desk.open({ recipe, title: 'sent', link: '#sent' });
  await tab.addHandle([0, 1], 'Low');
  expect(tab.link).toBe('#sent');
  await tab.openCube();
  expect(tab.link).toBeUndefined();
  const points = await tab.app.autosave.restorePoints();
  await tab.app.autosave.restore(points.find(({ title }) => title === 'sent')!.id);
  expect(tab.link).toBe('#sent');
});

test('the oldest restore points go, with the files nobody names any more', async () => {
  const tab = new Tab();
  for (let i = 0; i < MOST_RESTORE_POINTS + 3; i++) {
    await tab.openCube();
    await tab.addHandle([i % 8], 'Low');
    await tab.app.autosave.flush();
  }
  expect(tab.browser.store.kept.size).toBe(MOST_RESTORE_POINTS);
  const named = new Set(
    [...tab.browser.store.kept.values()].flatMap(({ entries, files }) => [
      ...entries.map(({ recipe }) => recipe),
      ...files.map(({ hash }) => hash),
    ]),
  );
  expect(new Set(tab.browser.store.blobs.keys())).toEqual(named);
});

test('a store that refuses is said once, and tried again with the next edit', async () => {
  const tab = await edited();
  tab.browser.store.broken = true;
  tab.deform.setMethod('naive');
  await tab.app.autosave.flush();
  expect(tab.app.state.saved.value.kind).toBe('failed');
  expect(tab.toasts.filter((text) => text.includes('the disk is full'))).toHaveLength(1);
  tab.browser.store.broken = false;
  tab.deform.setMethod('implicit');
  await tab.app.autosave.flush();
  expect(tab.app.state.saved.value.kind).toBe('saved');
});

test('a document kept by an earlier version comes back with its selection', async () => {
  const tab = await edited();
  tab.app.document.select(0);
  await tab.app.autosave.flush();
  const { kept } = tab.browser.store;
  const [[id, document]] = [...kept] as [[string, StoredDocument]];
  // As it was written before any step had items: every selection was of a handle.
  const entries = document.entries.map(({ selection, ...entry }) => ({
    ...entry,
    selection: { step: selection.step, handle: selectionOf(selection).item },
  }));
  kept.set(id, { ...document, entries });
  const later = tab.reloaded();
  expect(await later.app.autosave.restoreLast()).toBe(true);
  expect(later.app.document.selection).toEqual({ step: 'deform 1', item: 0 });
  later.app.document.undo();
  expect(later.app.document.selection.step).toBe('deform 1');
});
