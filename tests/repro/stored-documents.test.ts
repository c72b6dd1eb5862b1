// A document in the browser's store that is none kept the app from starting: its fields were taken for granted.

import { expect, test } from 'vitest';
import type { StoredDocument } from '../../web/app/store';
import { type Browser, Tab } from '../app/world';

async function kept(): Promise<{ document: StoredDocument; browser: Browser }> {
  const tab = new Tab();
  await tab.openCube();
  await tab.addHandle([0, 1], 'Low');
  await tab.app.autosave.flush();
  const [document] = tab.browser.store.kept.values();
  tab.close();
  return { document: document!, browser: tab.browser };
}

test.each([
  ['no entries', { entries: undefined }],
  ['an entry that is none', { entries: [null] }],
  ['a selection of nothing', { entries: [{ recipe: 'x', selection: null, label: '', time: 1 }] }],
  ['an index between two entries', { index: 0.5 }],
  ['no files', { files: 7 }],
  ['a file that is none', { files: [null] }],
])('a document with %s is passed over, and said so; the others open', async (_, damage) => {
  const { document, browser } = await kept();
  browser.store.kept.set('broken', {
    ...document,
    id: 'broken',
    time: 9e9,
    ...damage,
  } as unknown as StoredDocument);
  const tab = new Tab(browser);
  expect(await tab.app.autosave.restoreLast()).toBe(true);
  await tab.app.evaluator.settled();
  expect(tab.app.document.recipe.steps[0]).toMatchObject({ handles: [{ name: 'Low' }] });
  expect((await tab.app.autosave.restorePoints()).map(({ id }) => id)).toEqual([document.id]);
  expect(tab.toasts).toEqual([
    'A restore point of this browser is damaged and was passed over. The others are whole.',
  ]);
  tab.close();
});
