// The match workspace on a kernel of few lines: every model is its own skin.

import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { parseRecipe } from '../../web/recipe/parse';
import { pointOf, type Spot } from '../../web/tools/match/places';
import { listed, serve } from './served';
import { CUBE_OBJ, Tab } from './world';

const MODELS = ['cow', 'dog', 'cat'].map((name) => listed(name, 'cube.obj'));

beforeEach(() =>
  serve({ 'index.json': JSON.stringify({ models: MODELS, examples: [] }), 'cube.obj': CUBE_OBJ }),
);
afterEach(() => vi.unstubAllGlobals());

const enter = (tab: Tab) => tab.app.commands.run('workspace.match');
const choose = (tab: Tab, name: string) => tab.app.state.choosing.value!.choose(name, { builtin: name });
const step = (tab: Tab) => tab.matchState.step.value!;

/** What follows the result has been read as well. */
async function settled(tab: Tab): Promise<void> {
  await tab.app.evaluator.settled();
  await new Promise((resolve) => setTimeout(resolve, 10));
}

/** A cube and another one, nothing marked. */
async function two(): Promise<Tab> {
  const tab = new Tab();
  await tab.openCube();
  await enter(tab);
  choose(tab, 'cow');
  await settled(tab);
  return tab;
}

/** A vertex of one of the models. */
function spot(tab: Tab, model: number, vertex: number): Spot {
  return { place: vertex, point: pointOf(tab.matchState.models.value[model]!, vertex)! };
}

/** Sets a marker on both. */
async function mark(tab: Tab, ...vertices: number[]): Promise<void> {
  for (const vertex of vertices) {
    const marker = step(tab).markers.length;
    tab.match.marking.set('place', marker, 0, spot(tab, 0, vertex));
    tab.match.marking.set('place', marker, 1, spot(tab, 1, vertex));
  }
  await settled(tab);
}

/** The same, marked and matched. */
async function matched(): Promise<Tab> {
  const tab = await two();
  await mark(tab, 0, 3, 6);
  await tab.app.commands.run('match.run');
  await settled(tab);
  return tab;
}

const matches = (tab: Tab) => tab.kernel.calls.filter((method) => method === 'match').length;

describe('choosing models', () => {
  test('until one is chosen nothing happens to the document', async () => {
    const tab = new Tab();
    await tab.openCube();
    const { recipe } = tab.app.document;
    await enter(tab);
    expect(tab.matchState.models.value).toHaveLength(1);
    expect(tab.app.document.recipe).toBe(recipe);
    choose(tab, 'cow');
    await settled(tab);
    expect(step(tab).models).toHaveLength(2);
    expect(tab.matchState.models.value).toHaveLength(2);
  });

  test('one more joins, and a model may be matched with itself', async () => {
    const tab = await two();
    await tab.app.commands.run('match.add');
    choose(tab, 'cow');
    await settled(tab);
    expect(step(tab).models.slice(1)).toEqual(['cow', 'cow 2']);
  });

  test('one that is left out takes along what went on with its skin', async () => {
    const tab = await matched();
    await tab.app.commands.run('match.add');
    choose(tab, 'dog');
    await settled(tab);
    tab.matchState.chosen.value = 1;
    tab.match.models.remove(2);
    await settled(tab);
    await mark(tab, 5);
    await tab.app.commands.run('match.again');
    await settled(tab);
    await tab.app.workspaces.goOn('deform');
    expect(tab.app.state.step.value).toMatchObject({ type: 'deform', model: 'match 1/cow' });
    await enter(tab);
    await settled(tab);
    await tab.app.commands.run('match.add');
    choose(tab, 'dog');
    await settled(tab);
    tab.match.models.remove(1);
    const deform = tab.app.document.recipe.steps.find(({ id }) => id === 'deform 2');
    expect(deform).toMatchObject({ model: 'cow' });
  });
});

describe('markers', () => {
  test('one on one model alone is kept, and leaves the match waiting', async () => {
    const tab = await two();
    tab.match.marking.set('place', 0, 0, spot(tab, 0, 2));
    await settled(tab);
    expect(step(tab).markers).toEqual([[2, null]]);
    expect(tab.match.marking.nextModel()).toBe(1);
    expect(tab.match.canRun()).toBe(false);
    expect(matches(tab)).toBe(0);
  });

  test('its counterpart is suggested, and taken by a command', async () => {
    const tab = await two();
    tab.match.marking.set('place', 0, 0, spot(tab, 0, 2));
    await settled(tab);
    expect(tab.matchState.ghosts.value).toMatchObject([{ marker: 0, model: 1 }]);
    await tab.app.commands.run('match.accept');
    await settled(tab);
    expect(step(tab).markers[0]![1]).not.toBeNull();
    expect(tab.match.marking.nextModel()).toBeNull();
    expect(tab.matchState.ghosts.value).toEqual([]);
  });

  test('the mirror gives a new marker its partner, and moves the two together', async () => {
    const tab = await two();
    // The cube stands beside the plane x = 0: its mirror image is a model of its own.
    tab.app.state.mirror.value = true;
    tab.match.marking.set('place', 0, 0, spot(tab, 0, 7));
    expect(step(tab).markers).toHaveLength(1);
    await settled(tab);
  });
});

describe('matching', () => {
  test('happens when it is asked for, with the markers as points', async () => {
    const tab = await matched();
    expect(matches(tab)).toBe(1);
    const { result, outdated } = tab.matchState;
    expect(outdated.value).toBe(false);
    expect(result.value!.skins).toHaveLength(2);
    expect(result.value!.quality[1]).toMatchObject({ mean: 0.002, p99: 0.01 });
    expect([...tab.kernel.matched[0]![0]!.slice(3, 6)]).toEqual([1, 1, 0]);
  });

  test('a later edit keeps the skins and says so; undo leads back without a run', async () => {
    const tab = await matched();
    const { skins } = tab.matchState.result.value!;
    await mark(tab, 5);
    expect(tab.matchState.outdated.value).toBe(true);
    expect(tab.matchState.result.value!.skins).toBe(skins);
    expect(matches(tab)).toBe(1);
    tab.app.document.undo();
    tab.app.document.undo();
    await settled(tab);
    expect(tab.matchState.outdated.value).toBe(false);
    expect(matches(tab)).toBe(1);
    tab.app.document.redo();
    tab.app.document.redo();
    await tab.app.commands.run('match.again');
    await settled(tab);
    expect([matches(tab), tab.matchState.outdated.value]).toEqual([2, false]);
  });

  test('the skins are there for the next step, and to be written', async () => {
    const tab = await matched();
    expect(tab.app.files.exportModels().map(({ name }) => name)).toEqual(step(tab).models);
    expect(tab.app.files.exportGroup()!.choices.map(({ format }) => format)).toEqual([
      'glb',
      'obj.zip',
      'ply.zip',
    ]);
    await tab.app.workspaces.goOn('deform');
    expect(tab.app.state.step.value).toMatchObject({ type: 'deform', model: `match 1/${step0(tab)}` });
    await enter(tab);
    await settled(tab);
    expect(matches(tab)).toBe(1);
  });

  test('what is stopped by hand waits for its button again', async () => {
    const tab = await two();
    await mark(tab, 0, 3, 6);
    let stop = () => {};
    tab.kernel.before = (method) =>
      method === 'match'
        ? new Promise((_, reject) => {
            stop = () => reject(new DOMException('', 'AbortError'));
          })
        : Promise.resolve();
    await tab.app.commands.run('match.run');
    await new Promise((resolve) => setTimeout(resolve, 300));
    tab.app.state.busy.value?.cancel?.();
    stop();
    tab.kernel.before = async () => {};
    await settled(tab);
    expect(tab.matchState.result.value).toBeNull();
    expect(tab.match.canRun()).toBe(true);
  });
});

const step0 = (tab: Tab) =>
  (tab.app.document.recipe.steps.find(({ type }) => type === 'match') as { models: string[] }).models[0];

describe('sharp edges', () => {
  test('that are picked are items like markers: taken, selected, left, undone', async () => {
    const tab = await two();
    tab.match.marking.setSharp(1, 0, [0, 1, 3]);
    expect(step(tab).sharp).toEqual([[], [[0, 1, 3]]]);
    expect(tab.matchState.sharp.value).toEqual({ model: 1, row: 0 });
    expect([tab.matchState.marker.value, tab.matchState.curve.value]).toEqual([null, null]);
    expect(tab.app.state.undoLabel.value).toBe('Keep an edge sharp');
    tab.match.marking.setSharp(0, 0, [4, 5]);
    await tab.app.commands.run('match.remove');
    expect(step(tab).sharp).toEqual([[], [[0, 1, 3]]]);
    expect(tab.app.state.undoLabel.value).toBe('Leave a sharp edge');
    tab.app.document.undo();
    tab.app.document.undo();
    tab.app.document.undo();
    expect(step(tab).sharp).toBeUndefined();
  });

  test('that an angle keeps are known before anything is matched, and asked for once', async () => {
    const tab = await two();
    expect(tab.matchState.kept.value).toEqual([]);
    tab.match.set({ sharpAngle: 40 });
    await settled(tab);
    expect(tab.matchState.kept.value.map((rows) => rows.length)).toEqual([1, 1]);
    const asked = () => tab.kernel.calls.filter((method) => method === 'sharpEdges').length;
    const before = asked();
    await mark(tab, 0, 3, 6);
    expect(asked()).toBe(before);
    tab.match.set({ sharpAngle: undefined });
    await settled(tab);
    expect(tab.matchState.kept.value).toEqual([]);
  });
});

describe('a pose first', () => {
  test('is made before the match, which takes what comes of it', async () => {
    const tab = await matched();
    const { markers } = step(tab);
    await tab.match.models.pose(1, 'deform');
    await settled(tab);
    const { recipe } = tab.app.document;
    expect(recipe.steps.map(({ id }) => id).slice(-2)).toEqual(['deform 2', 'match 1']);
    expect(tab.app.state.step.value).toMatchObject({ id: 'deform 2', model: 'cow' });
    expect(tab.app.state.workspace.value).toBe('deform');
    await enter(tab);
    await settled(tab);
    expect(step(tab)).toMatchObject({ models: ['cube', 'deform 2'], markers });
    expect(tab.matchState.models.value).toHaveLength(2);
    expect(matches(tab)).toBe(1);
    await tab.app.commands.run('match.run');
    await settled(tab);
    expect(matches(tab)).toBe(2);
    // Posed once, it is that pose which is opened.
    await tab.match.models.pose(1, 'deform');
    expect(tab.app.state.step.value).toMatchObject({ id: 'deform 2' });
    expect(tab.app.document.recipe.steps).toHaveLength(recipe.steps.length);
  });

  test('by curves; undone it is gone, and the match is what it was', async () => {
    const tab = await matched();
    const before = tab.app.document.recipe;
    await tab.match.models.pose(0, 'curves');
    expect(tab.app.state.step.value).toMatchObject({ type: 'curves', model: 'cube' });
    expect(parseRecipe(JSON.stringify(tab.app.document.recipe))).toEqual(tab.app.document.recipe);
    tab.app.document.undo();
    expect(tab.app.document.recipe).toBe(before);
  });
});
