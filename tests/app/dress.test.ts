// The dress workspace on a kernel of few lines: cloth goes along with the body's first vertex, and up by the ease.

import { effect } from '@preact/signals';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { parseRecipe } from '../../web/recipe/parse';
import { matchedTab, settled, stubGallery } from './matched';
import { Tab } from './world';

beforeEach(stubGallery);
afterEach(() => vi.unstubAllGlobals());

const step = (tab: Tab) => tab.dressState.step.value!;
const shown = (tab: Tab) => tab.app.evaluator.result.value!;

/** A coat that was made for ann, on bob. */
async function dressed(): Promise<Tab> {
  const tab = await matchedTab('dress');
  tab.app.state.choosing.value!.choose('coat', { builtin: 'coat' });
  await settled(tab);
  return tab;
}

test('without a match there is nobody to dress, and nothing changes', async () => {
  const tab = new Tab();
  await tab.openCube();
  const { recipe } = tab.app.document;
  await tab.app.commands.run('workspace.dress');
  expect(tab.toasts[0]).toContain('There is nobody to dress yet');
  expect(tab.app.document.recipe).toBe(recipe);
});

test('the workspace asks what is worn, and leaves no trace where nothing is chosen', async () => {
  const tab = await matchedTab('dress');
  const { recipe } = tab.app.document;
  expect(tab.app.state.workspace.value).toBe('dress');
  expect(tab.dressState.source.value!.model.name).toBe('ann');
  tab.dress.choice.cancel();
  expect(tab.app.document.recipe).toBe(recipe);
});

test('what is chosen is put on the next body, which stands on screen with it', async () => {
  const tab = await dressed();
  expect(step(tab)).toMatchObject({ garment: 'coat', match: 'match 1', from: 'ann', to: 'bob', offset: 0 });
  expect(shown(tab).wearer!.model.name).toBe('bob');
  expect(shown(tab).shown.model.name).toBe('coat');
  expect(tab.dressState.figures.value).toMatchObject({ before: 7, after: 0 });
  expect(parseRecipe(JSON.stringify(tab.app.document.recipe))).toEqual(tab.app.document.recipe);
});

test('the ease follows the slider, is one step of undo, and prepares nothing again', async () => {
  const tab = await dressed();
  const { length } = tab.app.document.entries;
  const low = shown(tab).positions[1]!;
  for (const ease of [0.1, 0.2]) {
    tab.dress.setOffset(ease, true);
    await tab.app.evaluator.settled();
    expect(shown(tab).positions[1]).toBeCloseTo(low + ease, 9);
  }
  tab.dress.edits.finish();
  await settled(tab);
  expect(tab.app.document.entries.length).toBe(length + 1);
  expect(tab.kernel.calls.filter((call) => call === 'prepareDress')).toHaveLength(1);
});

test('who it was made for and who wears it are never the same', async () => {
  const tab = await dressed();
  tab.dress.setFrom('bob');
  expect(step(tab)).toMatchObject({ from: 'bob', to: 'ann' });
  tab.dress.setTo('cid');
  expect(step(tab)).toMatchObject({ from: 'bob', to: 'cid' });
});

test('the same garment is fitted to the next body, and another one is worn with it', async () => {
  const tab = await dressed();
  await tab.app.commands.run('dress.another');
  await settled(tab);
  expect(step(tab)).toMatchObject({ id: 'dress 2', garment: 'coat', to: 'cid' });
  expect(tab.app.commands.isEnabled('dress.another')).toBe(false);
  await tab.app.commands.run('dress.add');
  tab.app.state.choosing.value!.choose('coat', { builtin: 'coat' });
  await settled(tab);
  expect(step(tab)).toMatchObject({ id: 'dress 3', to: 'cid' });
  expect(tab.dressState.others.value.map(({ id }) => id)).toEqual(['dress 2']);
});

test('what one body wears beside is never seen on the next', async () => {
  const tab = await dressed();
  await tab.app.commands.run('dress.another');
  await settled(tab);
  await tab.app.commands.run('dress.add');
  tab.app.state.choosing.value!.choose('coat', { builtin: 'coat' });
  await settled(tab);
  const seen = new Set<string>();
  const stop = effect(() => {
    const wearer = tab.app.evaluator.result.value?.wearer?.model.name;
    const others = tab.dressState.others.value;
    // Once all who follow the result have.
    queueMicrotask(() => {
      if (wearer === 'bob' && tab.dressState.others.peek() === others)
        for (const { id } of others) seen.add(id);
    });
  });
  tab.dress.setTo('bob');
  await settled(tab);
  stop();
  expect([...seen]).toEqual(['dress 1']);
});

test('what is exported is the garment, not who wears it', async () => {
  const tab = await dressed();
  await tab.app.files.exportModel('obj');
  expect(new TextDecoder().decode(tab.saved[0]!.bytes)).toContain('1.1');
});
