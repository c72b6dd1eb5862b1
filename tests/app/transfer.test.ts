// The transfer workspace on a kernel of few lines: a cube has a pose, another one gets it.

import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { parseRecipe } from '../../web/recipe/parse';
import { pointAt } from '../../web/tools/geometry';
import { listed, serve } from './served';
import { CUBE_OBJ, file, Tab } from './world';

const MODELS = ['cow', 'dog'].map((name) => listed(name, 'cube.obj'));

beforeEach(() =>
  serve({ 'index.json': JSON.stringify({ models: MODELS, examples: [] }), 'cube.obj': CUBE_OBJ }),
);
afterEach(() => vi.unstubAllGlobals());

/** A tab in which a cube has a pose: its foot stays, its tip has moved by 2 along x. */
async function posed(): Promise<Tab> {
  const tab = new Tab();
  await tab.openCube();
  await tab.addHandle([7], 'Tip');
  await tab.addHandle([0, 1], 'Foot');
  tab.deform.setPose(0, { translation: [2, 0, 0] });
  await tab.app.evaluator.settled();
  return tab;
}

/** The same, with another cube chosen to get it. */
async function chosen(): Promise<Tab> {
  const tab = await posed();
  await enter(tab);
  tab.app.state.choosing.value!.choose('cow', { builtin: 'cow' });
  await settled(tab);
  return tab;
}

/** The same, with its two handles paired. */
async function given(): Promise<Tab> {
  const tab = await chosen();
  pair(tab, 0, [6]);
  pair(tab, 1, [2, 3]);
  await settled(tab);
  return tab;
}

const enter = (tab: Tab) => tab.app.commands.run('workspace.transfer');
const step = (tab: Tab) => tab.transferState.step.value!;
const shown = (tab: Tab) => tab.app.evaluator.result.value!;
const pair = (tab: Tab, handle: number, vertices: number[]) =>
  tab.transfer.setCounterpart(handle, Uint32Array.from(vertices), 'paint');

/** What follows the result has been read as well. */
async function settled(tab: Tab): Promise<void> {
  await tab.app.evaluator.settled();
  await new Promise((resolve) => setTimeout(resolve, 10));
}

test('without a pose there is nothing to give, and nothing changes', async () => {
  const tab = new Tab();
  await tab.openCube();
  const { recipe } = tab.app.document;
  await enter(tab);
  expect(tab.toasts).toEqual([
    'There is no pose to give yet. Pose a model by handles in the Deform workspace first.',
  ]);
  expect(tab.app.state.workspace.value).toBe('deform');
  expect(tab.app.document.recipe).toBe(recipe);
});

test('the workspace asks for a model beside the one that is posed, and leaves no trace where none is chosen', async () => {
  const tab = await posed();
  const { recipe } = tab.app.document;
  await enter(tab);
  expect(tab.app.state.workspace.value).toBe('transfer');
  const { source } = tab.transferState;
  expect(source.value!.id).toBe('deform 1');
  expect(pointAt(source.value!.posed, 7)).toEqual([3, 1, 1]);
  await tab.app.commands.run('workspace.deform');
  expect(tab.app.state.workspace.value).toBe('deform');
  expect(tab.app.document.recipe).toBe(recipe);
});

test('the chosen model begins a step, its first handle in hand', async () => {
  const tab = await chosen();
  expect(step(tab)).toMatchObject({ id: 'transfer 1', model: 'cow', like: 'deform 1', handles: [[], []] });
  expect(tab.app.state.selection.value.item).toBe(0);
  expect(tab.app.state.tool.value).toBe('paint-pair');
  expect(tab.app.state.status.value).toContain('what matches Tip');
  expect(shown(tab).inputs.map(({ model }) => model.name)).toEqual(['cow', 'cube.obj']);
  expect(shown(tab).report).toBeNull();
  expect(tab.kernel.calls).not.toContain('prepareTransfer');
  tab.app.document.undo();
  expect(tab.app.state.workspace.value).toBe('deform');
});

test('a file that is dropped meanwhile is the model', async () => {
  const tab = await posed();
  await enter(tab);
  await tab.app.files.openFiles([file('my cow.obj', CUBE_OBJ)]);
  await settled(tab);
  expect(step(tab)).toMatchObject({ model: 'my cow', like: 'deform 1' });
});

test('with two pairs the pose is given; every pair is a step of undo', async () => {
  const tab = await chosen();
  pair(tab, 0, [6]);
  await settled(tab);
  expect(shown(tab).report).toBeNull();
  expect(tab.transfer.open()).toEqual([1]);
  pair(tab, 1, [2, 3]);
  await settled(tab);
  expect(pointAt(shown(tab).positions, 6)).toEqual([2, 1, 1]);
  expect(tab.transferState.figures.value).toEqual({ unknowns: 40, iterations: 1, prepare: 3, transfer: 2 });
  expect(tab.transferState.whatItDid.value).toMatchObject({
    volumeRatio: 1,
    flippedTriangles: 0,
    closed: true,
  });
  expect(tab.app.state.undoLabel.value).toBe('Mark the counterpart of Foot');
  tab.app.document.undo();
  await settled(tab);
  expect(pointAt(shown(tab).positions, 6)).toEqual([0, 1, 1]);
  expect(tab.transferState.figures.value).toBeNull();
  tab.app.document.redo();
  await settled(tab);
  expect(pointAt(shown(tab).positions, 6)).toEqual([2, 1, 1]);
});

test('a vertex belongs to one counterpart: painted again it changes sides', async () => {
  const tab = await given();
  pair(tab, 0, [3, 6]);
  expect(step(tab).handles).toEqual([[3, 6], [2]]);
  tab.transfer.clear(0);
  expect(step(tab).handles).toEqual([[], [2]]);
  expect(tab.app.state.undoLabel.value).toBe('Remove the counterpart of Tip');
});

test('handles without a counterpart are taken one after the other', async () => {
  const tab = await chosen();
  tab.app.document.select(null);
  const item = () => tab.app.state.selection.value.item;
  await tab.app.commands.run('transfer.next');
  expect(item()).toBe(0);
  await tab.app.commands.run('transfer.next');
  expect(item()).toBe(1);
  await tab.app.commands.run('transfer.next');
  expect(item()).toBe(0);
  pair(tab, 0, [6]);
  await tab.app.commands.run('transfer.next');
  expect(item()).toBe(1);
  pair(tab, 1, [2]);
  expect(tab.app.commands.isEnabled('transfer.next')).toBe(false);
});

test('the strength follows the slider and is one step of undo; nothing is prepared again', async () => {
  const tab = await given();
  const before = tab.app.document.entries.length;
  for (const strength of [0.9, 0.7, 0.5]) {
    tab.transfer.setStrength(strength, true);
    await tab.app.evaluator.settled();
    expect(pointAt(shown(tab).positions, 6)[0]).toBeCloseTo(2 * strength, 12);
  }
  tab.transfer.edits.finish();
  await settled(tab);
  expect(step(tab).strength).toBe(0.5);
  expect(tab.app.document.entries.length).toBe(before + 1);
  tab.transfer.setKeepStretch(true);
  await settled(tab);
  expect(step(tab).keepStretch).toBe(true);
  expect(tab.kernel.calls.filter((call) => call === 'prepareTransfer')).toHaveLength(1);
});

test('both models can be looked at as they are at rest', async () => {
  const tab = await given();
  await tab.app.commands.run('transfer.rest');
  await settled(tab);
  expect(pointAt(shown(tab).positions, 6)).toEqual([0, 1, 1]);
  await tab.app.commands.run('transfer.rest');
  await settled(tab);
  expect(pointAt(shown(tab).positions, 6)).toEqual([2, 1, 1]);
});

test('the result is deformed further, exported, and the way back leads to the transfer', async () => {
  const tab = await given();
  await tab.app.files.exportModel('obj');
  expect(tab.saved).toHaveLength(1);
  await tab.app.commands.run('transfer.deform');
  await settled(tab);
  expect(tab.app.state.step.value).toMatchObject({ id: 'deform 2', model: 'transfer 1' });
  expect(pointAt(shown(tab).positions, 6)).toEqual([2, 1, 1]);
  await enter(tab);
  expect(step(tab).id).toBe('transfer 1');
});

test('another model gets the same pose in a step of its own', async () => {
  const tab = await given();
  await tab.app.commands.run('transfer.another');
  tab.app.state.choosing.value!.choose('dog', { builtin: 'dog' });
  await settled(tab);
  expect(step(tab)).toMatchObject({ id: 'transfer 2', model: 'dog', like: 'deform 1', handles: [[], []] });
  expect(tab.app.commands.isEnabled('transfer.by-name')).toBe(false);
});

test('another model in the place of the first loses its counterparts, not the strength', async () => {
  const tab = await given();
  tab.transfer.setStrength(0.5);
  await tab.app.commands.run('transfer.target');
  tab.app.state.choosing.value!.choose('dog', { builtin: 'dog' });
  await settled(tab);
  expect(step(tab)).toMatchObject({ id: 'transfer 1', model: 'dog', handles: [[], []], strength: 0.5 });
  expect(Object.keys(tab.app.document.recipe.models)).toEqual(['cube', 'dog']);
});

test('a recipe with a transfer can be shared as a link once its models are built in', async () => {
  const tab = await given();
  expect(await tab.app.share.link()).toMatchObject({ kind: 'needs-file' });
});

describe('several poses', () => {
  /** A second pose of the same handles: the tip is moved by 5. */
  async function second(): Promise<Tab> {
    const tab = await given();
    await tab.app.commands.run('transfer.new-pose');
    await settled(tab);
    tab.deform.setPose(0, { translation: [5, 0, 0] });
    await settled(tab);
    return tab;
  }

  test('a new one is a copy to be changed, and given from then on', async () => {
    const tab = await second();
    expect(tab.app.document.recipe.steps.map(({ id }) => id)).toEqual(['deform 1', 'deform 2', 'transfer 1']);
    expect(tab.app.state.step.value).toMatchObject({ id: 'deform 2', model: 'cube' });
    await enter(tab);
    await settled(tab);
    expect(pointAt(shown(tab).positions, 6)).toEqual([5, 1, 1]);
    expect(tab.transferState.source.value!.id).toBe('deform 2');
    expect(pointAt(tab.transferState.source.value!.posed, 7)).toEqual([6, 1, 1]);
  });

  test('one of them is chosen, and the pairs go along', async () => {
    const tab = await second();
    await enter(tab);
    expect(tab.transfer.poses().map(({ id }) => id)).toEqual(['deform 1', 'deform 2']);
    tab.transfer.choosePose('deform 1');
    await settled(tab);
    expect(pointAt(shown(tab).positions, 6)).toEqual([2, 1, 1]);
    expect(tab.transfer.open()).toEqual([]);
    expect(tab.kernel.calls.filter((call) => call === 'prepareTransfer')).toHaveLength(1);
  });

  test('the pose is changed where it was made, and the transfer follows', async () => {
    const tab = await given();
    await tab.app.commands.run('transfer.edit-pose');
    await settled(tab);
    expect(tab.app.state.workspace.value).toBe('deform');
    tab.deform.setPose(0, { translation: [9, 0, 0] });
    await settled(tab);
    await enter(tab);
    await settled(tab);
    expect(pointAt(shown(tab).positions, 6)).toEqual([9, 1, 1]);
  });
});

test('of several transfers the one of the open pose is opened', async () => {
  const tab = await given();
  await tab.app.commands.run('transfer.new-pose');
  await tab.app.commands.run('workspace.transfer');
  await tab.app.commands.run('transfer.another');
  tab.app.state.choosing.value!.choose('dog', { builtin: 'dog' });
  tab.transfer.choosePose('deform 1');
  await settled(tab);
  const opened = async (pose: string) => {
    tab.app.document.openStep(pose);
    await enter(tab);
    return step(tab).id;
  };
  expect(await opened('deform 2')).toBe('transfer 1');
  expect(await opened('deform 1')).toBe('transfer 2');
});

describe('a pose that has changed since', () => {
  test('with another number of handles it says so, and is matched again', async () => {
    const tab = await given();
    await tab.app.commands.run('transfer.edit-pose');
    await tab.addHandle([5], 'Ear');
    await enter(tab);
    await settled(tab);
    expect(tab.transferState.problem.value).toContain('other handles');
    expect(pointAt(shown(tab).positions, 6)).toEqual([0, 1, 1]);
    tab.transfer.fitHandles();
    await settled(tab);
    expect(tab.transferState.problem.value).toBeNull();
    expect(step(tab).handles).toHaveLength(3);
    expect(tab.transfer.open()).toEqual([2]);
    expect(pointAt(shown(tab).positions, 6)).toEqual([2, 1, 1]);
  });

  test('a counterpart that is painted matches them as well', async () => {
    const tab = await given();
    await tab.app.commands.run('transfer.edit-pose');
    tab.deform.remove(1);
    await enter(tab);
    await settled(tab);
    pair(tab, 0, [6, 7]);
    expect(step(tab).handles).toEqual([[6, 7]]);
  });

  test('removed, it is missed; the recipe can still be read', async () => {
    const tab = await given();
    tab.app.document.removeStep('deform 1');
    await settled(tab);
    expect(tab.transferState.problem.value).toContain('is gone');
    expect(tab.transferState.source.value).toBeNull();
    expect(tab.transfer.poses()).toEqual([]);
    const { recipe } = tab.app.document;
    expect(parseRecipe(JSON.stringify(recipe))).toEqual(recipe);
    tab.app.document.undo();
    await settled(tab);
    expect(pointAt(shown(tab).positions, 6)).toEqual([2, 1, 1]);
  });
});
