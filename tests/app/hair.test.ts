import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { growsAlike } from '../../web/app/hair/evaluation';
import { tallness } from '../../web/app/hair/head-height';
import { frameHair } from '../../web/app/hair/opening';
import { fitted } from '../../web/app/hair/refit';
import { growOn } from '../../web/app/hair/start';
import { LissomError } from '../../web/core/errors';
import type { Model } from '../../web/core/model';
import type { HairStep } from '../../web/recipe/recipe';
import { newHairStep } from '../../web/recipe/steps/hair';
import { PREVIEW_STRANDS } from '../../web/run/steps/hair';
import { serve } from './served';
import { file, Tab } from './world';

/** A cube with hair on the top, twice as high for the second head. */
const head = (height: number): string =>
  [
    'ply\nformat ascii 1.0\nelement vertex 8',
    'property float x\nproperty float y\nproperty float z\nproperty uchar scalp',
    'element face 12\nproperty list uchar int vertex_indices\nend_header',
    ...[0, 1, 2, 3, 4, 5, 6, 7].map(
      (i) => `${(i & 1) - 0.5} ${((i >> 1) & 1) * height} ${(i >> 2) - 0.5} ${(i >> 1) & 1}`,
    ),
    '3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4',
    '3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 7 5\n',
  ].join('\n');

const entry = (name: string) => ({
  name,
  file: `${name}.ply`,
  title: name,
  licence: '',
  vertices: 8,
  scalp: true,
});
const GALLERY: Readonly<Record<string, string>> = {
  'index.json': JSON.stringify({ models: [entry('head-female'), entry('head-male')], examples: [] }),
  'head-female.ply': head(1),
  'head-male.ply': head(2),
};

beforeEach(() => serve(GALLERY));
afterEach(() => vi.unstubAllGlobals());

const stroke: HairStep['streams'][number] = {
  points: [
    [0.1, 1, 0],
    [0.3, 1, 0.2],
    [0.6, 0.6, 0.2],
  ],
  fade: false,
};

/** A tab with hair on the first head, and one stream. */
async function styled(): Promise<Tab> {
  const tab = new Tab();
  await tab.app.commands.run('workspace.hair');
  draw(tab);
  await tab.app.evaluator.settled();
  return tab;
}

function draw(tab: Tab, more: Partial<HairStep> = {}): void {
  const { document } = tab.app;
  const step = { ...tab.hairState.step.value!, streams: [stroke], ...more };
  const steps = document.recipe.steps.map((each) => (each.id === step.id ? step : each));
  document.commit('Draw', { ...document.recipe, steps }, { step: step.id, item: 0 });
}

const step = (tab: Tab): HairStep => tab.hairState.step.value!;

test('the hair workspace opens on a head, with the stream tool in hand', async () => {
  const tab = new Tab();
  await tab.app.commands.run('workspace.hair');
  await tab.app.evaluator.settled();
  const { state, document } = tab.app;
  expect(state.workspace.value).toBe('hair');
  expect(state.tool.value).toBe('stream');
  expect(document.recipe.models).toEqual({ 'head-female': { builtin: 'head-female' } });
  expect(state.facts.value).toMatchObject({ name: 'head-female', vertices: 8 });
  expect(tab.toasts).toEqual([]);
});

test('somebody’s work is joined by a head, and undo takes it out again', async () => {
  const tab = new Tab();
  await tab.openCube();
  await tab.addHandle([0], 'Tip');
  const before = tab.app.document.recipe;
  await tab.app.commands.run('workspace.hair');
  expect(tab.app.document.recipe.steps.map(({ type }) => type)).toEqual(['deform', 'hair']);
  await tab.app.commands.run('workspace.deform');
  expect(tab.app.state.workspace.value).toBe('deform');
  expect(tab.app.state.tool.value).toBe('select');
  await tab.app.commands.run('workspace.hair');
  expect(tab.app.document.recipe.steps).toHaveLength(2);
  while (tab.app.document.recipe !== before) tab.app.document.undo();
  expect(tab.app.state.workspace.value).toBe('deform');
});

test('a model of one’s own grows hair once a scalp is painted on it, and not before', async () => {
  const tab = new Tab();
  await tab.openCube();
  await tab.app.wings.load('hair');
  growOn(tab.app, 'cube', '');
  await tab.app.evaluator.settled();
  expect(tab.app.state.tool.value).toBe('paint-scalp');
  expect(tab.hair.scalpSize()).toBe(0);
  expect(tab.kernel.grown).toEqual([]);
  expect(tab.toasts).toEqual([]);
  draw(tab, { scalp: [2, 3, 6, 7] });
  await tab.app.evaluator.settled();
  expect(tab.hair.scalpSize()).toBe(4);
  expect(tab.app.evaluator.result.value!.strands).not.toBeNull();
});

test('a head that has hair can be deformed; the hair follows its new shape', async () => {
  const tab = await styled();
  await tab.app.commands.run('workspace.deform');
  const [deform, hair] = tab.app.document.recipe.steps;
  expect(deform).toMatchObject({ type: 'deform', model: 'head-female' });
  expect(hair).toMatchObject({ type: 'hair', model: deform!.id });
});

test('the first strands are there before all of them', async () => {
  const tab = await styled();
  const { count } = step(tab).strands;
  expect(tab.kernel.grown.slice(-2)).toEqual([PREVIEW_STRANDS, count]);
  expect(tab.app.evaluator.result.value).toMatchObject({ settled: true });
  expect(tab.hairState.figures.value).toMatchObject({ strands: count, constraints: 10, grow: 300 });
});

test('while a slider is held only the first strands grow; all of them when it is let go', async () => {
  const tab = await styled();
  tab.kernel.grown.length = 0;
  tab.hair.update({ detail: { curl: 0.3 } }, true);
  await tab.app.evaluator.settled();
  tab.hair.update({ detail: { curl: 0.6 } }, true);
  await tab.app.evaluator.settled();
  expect(tab.kernel.grown).toEqual([PREVIEW_STRANDS, PREVIEW_STRANDS]);
  tab.hair.finish();
  await tab.app.evaluator.settled();
  expect(tab.kernel.grown.slice(2)).toEqual([step(tab).strands.count]);
  expect(step(tab).detail.curl).toBe(0.6);
  tab.app.document.undo();
  expect(step(tab).detail.curl).toBe(0);
});

test('a new stroke does not wait for the strands of the last one', async () => {
  const tab = await styled();
  let aborted = 0;
  tab.kernel.before = (method) =>
    method === 'growHair' && tab.kernel.grown.length === 0
      ? new Promise((_, reject) => {
          tab.kernel.grown.push(-1);
          release = () => reject(new LissomError('cancelled', 'Cancelled.', 'cancelled'));
          aborted++;
        })
      : Promise.resolve();
  let release = () => {};
  tab.kernel.grown.length = 0;
  tab.hair.update({ length: { variation: 0.4 } });
  await vi.waitFor(() => expect(aborted).toBe(1));
  tab.hair.update({ length: { variation: 0.5 } }, true);
  release();
  await tab.app.evaluator.settled();
  expect(tab.app.evaluator.result.value!.step).toMatchObject({ length: { variation: 0.5 } });
  expect(tab.toasts).toEqual([]);
});

test('a change of colour finds the strands as they are', async () => {
  const tab = await styled();
  const before = tab.app.evaluator.result.value!.strands!;
  tab.kernel.grown.length = 0;
  tab.hair.update({ material: { melanin: 0.1 } }, true);
  await tab.app.evaluator.settled();
  tab.hair.update({ material: { color: '#2233ff' } });
  await tab.app.evaluator.settled();
  const after = tab.app.evaluator.result.value!.strands!;
  expect(tab.kernel.grown).toEqual([]);
  expect(after.points).toBe(before.points);
  expect(after.look.color).toBe('#2233ff');
  expect(after.look.thickness).toBe(before.look.thickness);
});

test('a field set back to its default leaves the recipe', async () => {
  const tab = await styled();
  const { material } = step(tab);
  tab.hair.update({ material: { color: '#112233' } });
  tab.hair.update({ material: { color: undefined } });
  expect(step(tab).material).toEqual(material);
});

test('curves are named by kind and number until they have names of their own', async () => {
  const tab = await styled();
  const { hair } = tab;
  hair.duplicate(0);
  expect([hair.primitiveName(0), hair.primitiveName(1)]).toEqual(['Stream 1', 'Stream 2']);
  hair.rename(0, '  Fringe ');
  expect(hair.primitiveName(0)).toBe('Fringe');
  expect(hair.primitiveName(1)).toBe('Stream 2');
  hair.hide(1, true);
  expect(step(tab).streams[1]!.hidden).toBe(true);
  expect(tab.app.state.undoLabel.value).toBe('Hide Stream 2');
  hair.remove(0);
  expect(step(tab).streams).toHaveLength(1);
  for (let i = 0; i < 4; i++) tab.app.document.undo();
  expect(step(tab).streams).toEqual([stroke]);
});

test('names and hiding grow nothing anew', async () => {
  const tab = await styled();
  tab.kernel.grown.length = 0;
  tab.hair.rename(0, 'Fringe');
  tab.hair.hide(0, true);
  await tab.app.evaluator.settled();
  expect(tab.kernel.grown).toEqual([]);
});

test('another head takes the style along: strokes move as the box around the scalp does', async () => {
  const tab = await styled();
  await tab.hair.setHead('head-male');
  await tab.app.evaluator.settled();
  expect(step(tab).model).toBe('head-male');
  expect(Object.keys(tab.app.document.recipe.models)).toEqual(['head-male']);
  expect(step(tab).streams[0]!.points.map(([x, , z]) => [x, z])).toEqual(
    stroke.points.map(([x, , z]) => [x, z]),
  );
  expect(step(tab).streams[0]!.points.map(([, y]) => y)).toEqual([2, 2, 1.6]);
  tab.app.document.undo();
  expect(step(tab).streams).toEqual([stroke]);
});

test('a style fitted to its own head stays where it is', () => {
  const model: Model = {
    name: 'head',
    positions: Float64Array.of(0, 0, 0, 1, 2, 0, 0, 2, 1, 1, 2, 1),
    faceOffsets: Uint32Array.of(0),
    faceVertices: new Uint32Array(),
    vertexSets: { scalp: Uint32Array.of(1, 2, 3) },
  };
  const own = { ...newHairStep('hair 1', 'head'), streams: [stroke] };
  const scalp = Uint32Array.of(1, 2, 3);
  expect(fitted(own, { model, scalp }, model).streams).toEqual(own.streams);
  expect(tallness(model)).toBe(2);
  expect(growsAlike(own, { ...own, material: { ...own.material, melanin: 0 } })).toBe(true);
  expect(growsAlike(own, { ...own, streams: [] })).toBe(false);
});

test('strands are written in each format offered, and without hair that is said', async () => {
  const tab = await styled();
  // The stand-in grows hair of no length; what matters here is that every writer is reached.
  const shown = tab.app.evaluator.result.value!.strands!;
  shown.points.forEach((_, i) => {
    shown.points[i] = (i % 6) / 10;
  });
  tab.hair.update({ strands: { count: 5 } });
  const group = tab.app.files.exportGroup()!;
  for (const { format } of group.choices) {
    const before = tab.saved.length;
    await tab.app.files.exportOf(group, format, false);
    expect(tab.saved.length, format).toBe(before + 1);
    expect(tab.saved.at(-1)!.name).toBe(`head-female.${format}`);
    expect(tab.saved.at(-1)!.bytes.length).toBeGreaterThan(20);
  }
  tab.hair.update({ strands: { count: 0 } });
  await expect(tab.app.files.exportOf(group, 'obj', false)).rejects.toThrow('There is no hair yet');
});

test('the status line says what the tool in hand does', async () => {
  const tab = await styled();
  const { state, commands } = tab.app;
  const said = new Set<string>();
  for (const id of ['hair-select', 'stream', 'hint', 'parting', 'ponytail', 'paint-scalp', 'paint-length']) {
    await commands.run(`tool.${id}`);
    expect(state.status.value).not.toMatch(/[{}]/);
    said.add(state.status.value);
  }
  expect(said.size).toBe(7);
  await commands.run('edit.cancel');
  expect(state.tool.value).toBe('hair-select');
});

test('a style opens without its curves; a tool or a selected curve brings them', async () => {
  const tab = await styled();
  const { state, document, commands, desk } = tab.app;
  const { recipe } = document;
  const curves = () => tab.hairState.show.value.curves;
  expect(curves()).toBe(true);
  const open = () => desk.open({ recipe, title: 'style' });
  await open();
  expect([curves(), state.tool.value]).toEqual([false, 'hair-select']);
  expect(state.status.value).toContain('C shows the curves');
  document.select(0);
  expect(curves()).toBe(true);
  for (const tool of ['stream', 'hair-select']) {
    await open();
    expect(curves()).toBe(false);
    await commands.run(`tool.${tool}`);
    expect(curves(), tool).toBe(true);
  }
  await commands.run('hair.show-curves');
  expect(curves()).toBe(false);
});

test('the first sight of a style is head and hair together; later strands leave the camera alone', async () => {
  const tab = await styled();
  const { state, evaluator, document, desk } = tab.app;
  const { hair } = tab;
  const seen: string[] = [];
  const viewport = { fit: () => seen.push('fit'), setView: (preset: string) => seen.push(preset) };
  const stop = frameHair({ viewport, state, evaluator });
  expect(seen.splice(0)).toEqual(['fit']);
  hair.update({ detail: { curl: 0.5 } });
  await evaluator.settled();
  expect(seen.splice(0)).toEqual([]);
  await desk.open({ recipe: document.recipe, title: 'again' });
  hair.update({ detail: { curl: 0.7 } });
  await evaluator.settled();
  expect(seen.splice(0)).toEqual(['home', 'fit']);
  await hair.setHead('head-male');
  await evaluator.settled();
  expect(seen).toEqual(['fit']);
  stop();
});

test('a recipe with hair opens in the hair workspace and saves and opens again as it was', async () => {
  const tab = await styled();
  await tab.app.files.save();
  const { recipe } = tab.app.document;
  const other = new Tab();
  await other.app.files.openFiles([file('style.zip', tab.saved[0]!.bytes)]);
  expect(other.app.state.workspace.value).toBe('hair');
  expect(other.app.document.recipe).toEqual(recipe);
});
