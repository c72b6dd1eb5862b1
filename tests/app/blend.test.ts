// The blend workspace on a kernel of few lines: three cubes, 1, 2 and 3 units large.

import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { parseRecipe } from '../../web/recipe/parse';
import { matchedTab, settled, stubGallery } from './matched';
import { Tab } from './world';

beforeEach(stubGallery);
afterEach(() => vi.unstubAllGlobals());

const step = (tab: Tab) => tab.blendState.step.value!;
const shown = (tab: Tab) => tab.app.evaluator.result.value!;
/** How large the cube on screen is. */
const size = (tab: Tab) => shown(tab).positions[3 * 7]!;

test('without a match there is nothing to blend, and nothing changes', async () => {
  const tab = new Tab();
  await tab.openCube();
  const { recipe } = tab.app.document;
  await tab.app.commands.run('workspace.blend');
  expect(tab.toasts).toEqual(['Nothing can be blended yet: match two or more models first.']);
  expect(tab.app.document.recipe).toBe(recipe);
  expect(tab.app.state.workspace.value).toBe('deform');
});

test('a blend begins with as much of each, and is a step of undo', async () => {
  const tab = await matchedTab('blend');
  expect(step(tab)).toMatchObject({ id: 'blend 1', match: 'match 1' });
  expect(size(tab)).toBeCloseTo(2, 9);
  expect(tab.blend.names()).toEqual(['ann', 'bob', 'cid']);
  expect(tab.blend.corners()).toEqual(['ann', 'bob', 'cid']);
  expect(tab.blendState.skins.value!.positions).toHaveLength(3);
  expect(parseRecipe(JSON.stringify(tab.app.document.recipe))).toEqual(tab.app.document.recipe);
  tab.app.document.undo();
  expect(tab.blendState.step.value).toBeUndefined();
});

describe('weights', () => {
  test('one that moves makes room: the others share what is left', async () => {
    const tab = await matchedTab('blend');
    tab.blend.only('cid');
    await settled(tab);
    expect(size(tab)).toBeCloseTo(3, 9);
    tab.blend.setWeight('cid', 0.5);
    await settled(tab);
    expect(step(tab).weights).toEqual({ ann: 0.25, bob: 0.25, cid: 0.5 });
    expect(tab.blend.sum()).toBe(1);
    expect(size(tab)).toBeCloseTo(2.25, 9);
  });

  test('free ones leave the others alone, which is said; made a whole it is taken back', async () => {
    const tab = await matchedTab('blend');
    tab.blend.only('ann');
    tab.blendState.free.value = true;
    tab.blend.setWeight('bob', 1);
    await settled(tab);
    expect(size(tab)).toBeCloseTo(3, 9);
    expect(tab.blend.sum()).toBe(2);
    expect(tab.app.state.warnings.value.map(({ code }) => code)).toEqual(['weights-not-whole']);
    await tab.app.commands.run('blend.normalise');
    await settled(tab);
    expect(size(tab)).toBeCloseTo(1.5, 9);
    expect(tab.app.state.warnings.value).toEqual([]);
  });

  test('the dot sets three at once, in one step of undo', async () => {
    const tab = await matchedTab('blend');
    const { length } = tab.app.document.entries;
    tab.blend.setShares([0.5, 0.5, 0], true);
    tab.blend.setShares([0, 0.5, 0.5], true);
    tab.blend.edits.finish();
    await settled(tab);
    expect(step(tab).weights).toEqual({ ann: 0, bob: 0.5, cid: 0.5 });
    expect(size(tab)).toBeCloseTo(2.5, 9);
    expect(tab.app.document.entries.length).toBe(length + 1);
    tab.app.document.undo();
    await settled(tab);
    expect(size(tab)).toBeCloseTo(2, 9);
  });

  test('while they move the graphics card has them, and the kernel is left alone', async () => {
    const tab = await matchedTab('blend');
    tab.blendState.movable.value = true;
    const calls = tab.kernel.calls.length;
    tab.blend.setShares([0.5, 0.5, 0], true);
    await tab.app.evaluator.settled();
    const first = shown(tab);
    expect([...first.moved!.table]).toEqual([0.5, 0.5, 0]);
    expect(first.settled).toBe(false);
    tab.blend.setShares([1, 0, 0], true);
    await tab.app.evaluator.settled();
    expect(shown(tab).moved!.motion).toBe(first.moved!.motion);
    expect(tab.kernel.calls.length).toBe(calls);
    tab.blend.edits.finish();
    await settled(tab);
    expect(shown(tab).moved).toBeNull();
    expect(size(tab)).toBeCloseTo(1, 9);
  });

  test('another model takes a corner; the one that was there goes where that came from', async () => {
    const tab = await matchedTab('blend');
    tab.blend.setCorner(0, 'cid');
    expect(tab.blend.corners()).toEqual(['cid', 'bob', 'ann']);
  });
});

describe('parts', () => {
  test('what is painted has the shape of the model that counts for least', async () => {
    const tab = await matchedTab('blend');
    tab.blend.only('ann');
    tab.blend.setWeight('bob', 0.2);
    await settled(tab);
    tab.blend.setVertices(null, Uint32Array.of(7), 'paint');
    await settled(tab);
    expect(step(tab).parts).toMatchObject([{ from: 'cid', vertices: [7], how: 'paste' }]);
    expect(size(tab)).toBe(3);
    expect(tab.app.state.selection.value.item).toBe(0);
    expect(tab.app.state.undoLabel.value).toBe('Add a part');
  });

  test('they are renamed without computing anything, given another shape, and erased away', async () => {
    const tab = await matchedTab('blend');
    tab.blend.setVertices(null, Uint32Array.of(7), 'paint');
    await settled(tab);
    const calls = tab.kernel.calls.length;
    tab.blend.changePart(0, { name: 'Nose' });
    await settled(tab);
    expect(tab.blend.partName(0)).toBe('Nose');
    expect(tab.kernel.calls.length).toBe(calls);
    tab.blend.changePart(0, { from: 'cid' });
    await settled(tab);
    expect(size(tab)).toBe(3);
    tab.blend.setVertices(0, new Uint32Array(), 'erase');
    await settled(tab);
    expect(step(tab).parts).toEqual([]);
    expect(tab.app.state.selection.value.item).toBeNull();
    expect(size(tab)).toBeCloseTo(2, 9);
  });

  test('while weights move what the parts add stays', async () => {
    const tab = await matchedTab('blend');
    tab.blend.only('ann');
    tab.blend.setVertices(null, Uint32Array.of(7), 'paint');
    tab.blend.changePart(0, { from: 'cid' });
    await settled(tab);
    tab.blendState.movable.value = true;
    tab.blend.setShares([0.5, 0.5, 0], true);
    await tab.app.evaluator.settled();
    const { motion } = shown(tab).moved!;
    const { beside } = (motion as unknown as { shapes: { beside: Float64Array } }).shapes;
    expect([beside[0], beside[3 * 7]]).toEqual([0, 2]);
  });
});

describe('measures', () => {
  test('the weights follow a measure that is held, and can be kept', async () => {
    const tab = await matchedTab('blend');
    await tab.app.commands.run('blend.height');
    await settled(tab);
    expect(tab.blend.measuring.rows()).toMatchObject([{ kind: 'height', name: 'Height', value: null }]);
    tab.blend.measuring.want(0, 0.75);
    await settled(tab);
    expect(tab.blend.measuring.isWanted()).toBe(true);
    expect(tab.blend.rows()[0]).toMatchObject({ name: 'ann', found: 0.75 });
    expect(tab.blend.measuring.rows()[0]).toMatchObject({ value: 0.75, reached: 0.75 });
    await tab.app.commands.run('blend.keep');
    await settled(tab);
    expect(step(tab).weights.ann).toBe(0.75);
    expect(tab.blend.measuring.isWanted()).toBe(false);
  });

  test('a length runs along edges from one place to another, or straight through', async () => {
    const tab = await matchedTab('blend');
    tab.blend.measuring.addLength(0, 7, false);
    await settled(tab);
    const [measure] = step(tab).measures;
    expect(measure).toMatchObject({ kind: 'length' });
    const path = measure?.kind === 'length' ? measure.path : [];
    // Over one side's diagonal and one edge, or three edges: never through the cube.
    expect(path.length).toBeGreaterThan(2);
    expect([path[0], path.at(-1)]).toEqual([0, 7]);
    expect(tab.blend.measuring.rows()).toMatchObject([
      { kind: 'length', name: 'Length 1', straight: false, value: null },
    ]);
    tab.blend.measuring.straighten(0, true);
    await settled(tab);
    expect(step(tab).measures).toEqual([{ kind: 'length', path: [0, 7] }]);
    tab.blend.measuring.want(0, 0.75);
    await settled(tab);
    expect(tab.blend.rows()[0]).toMatchObject({ name: 'ann', found: 0.75 });
    tab.app.document.undo();
    tab.app.document.undo();
    expect(step(tab).measures[0]).toEqual(measure);
    tab.blend.measuring.remove(0);
    expect(step(tab).measures).toEqual([]);
  });

  test('a length that is begun is given up by Escape, and by another tool', async () => {
    const tab = await matchedTab('blend');
    await tab.app.commands.run('tool.measure-length');
    tab.blendState.length.value = { from: 3, to: null, straight: false };
    await tab.app.commands.run('edit.cancel');
    expect(tab.blendState.length.value).toBeNull();
  });

  test('a slider goes somewhat beyond what the models have', async () => {
    const tab = await matchedTab('blend');
    tab.blend.measuring.addGirth(7);
    await settled(tab);
    // By the kernel here: 1 of the first model, 0 of the others.
    expect(tab.blendState.spread.value).toEqual({ ann: [1], bob: [0], cid: [0] });
    expect(tab.blend.measuring.rows()[0]!.range).toEqual([0, 1.5]);
    tab.blend.measuring.remove(0);
    await settled(tab);
    expect(tab.blend.measuring.rows()).toEqual([]);
  });
});

test('the result is deformed further, and the way back leads to the blend', async () => {
  const tab = await matchedTab('blend');
  await tab.app.commands.run('blend.deform');
  await settled(tab);
  expect(tab.app.state.step.value).toMatchObject({ type: 'deform', model: 'blend 1' });
  expect(size(tab)).toBeCloseTo(2, 9);
  await tab.app.commands.run('workspace.blend');
  expect(step(tab).id).toBe('blend 1');
});
