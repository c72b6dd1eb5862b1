// The merge workspace on the real kernel: a lid for a bowl, and the other ways to put two models together.

import { afterEach, beforeAll, beforeEach, expect, test, vi } from 'vitest';
import { meetingOf } from '../../web/app/merge/meeting';
import { LissomError } from '../../web/core/errors';
import { writeModel } from '../../web/io/index';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import type { Loop } from '../../web/tools/merge/loops';
import { MeshGraph } from '../../web/tools/mesh-graph';
import { bowl, dome, tube } from '../kernel/tubes';
import { sheet } from '../tools/merge/shapes';
import { serve } from './served';
import { file, Tab } from './world';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const LID = writeModel({ name: 'lid', ...tube(12, 20, dome) }, 'obj');
const BOWL = writeModel({ name: 'bowl', ...tube(12, 31, bowl, false) }, 'obj');
const entry = { name: 'lid', file: 'lid.obj', title: 'Lid', licence: '', vertices: 241 };

beforeEach(() =>
  serve({
    'index.json': JSON.stringify({ models: [entry], examples: [] }),
    'lid.obj': LID as Uint8Array<ArrayBuffer>,
  }),
);
afterEach(() => vi.unstubAllGlobals());

/** A tab with a bowl of one's own open, working on the real kernel. */
async function bowlOpen(): Promise<Tab> {
  const tab = new Tab();
  tab.kernel.call = kernel.call.bind(kernel) as Tab['kernel']['call'];
  await tab.app.files.openFiles([file('bowl.obj', BOWL)]);
  await tab.app.evaluator.settled();
  return tab;
}

/** The same, with the lid chosen as the part to add. */
async function lidChosen(): Promise<Tab> {
  const tab = await bowlOpen();
  await tab.app.commands.run('workspace.merge');
  tab.app.state.choosing.value!.choose('lid', { builtin: 'lid' });
  await tab.app.evaluator.settled();
  return tab;
}

const merged = (tab: Tab) => tab.mergeState.figures.value;
const step = (tab: Tab) => tab.mergeState.step.value!;

test('the merge workspace asks for a part, and leaves no trace where none is chosen', async () => {
  const tab = await bowlOpen();
  const { recipe } = tab.app.document;
  await tab.app.commands.run('workspace.merge');
  expect(tab.app.state.workspace.value).toBe('merge');
  expect(tab.app.state.choosing.value).not.toBeNull();
  expect(tab.mergeState.sides.value.target!.model.name).toBe('bowl.obj');
  await tab.app.commands.run('workspace.deform');
  expect(tab.app.state.workspace.value).toBe('deform');
  expect(tab.app.document.recipe).toBe(recipe);
});

test('the part begins a step on the open model, to be marked before anything is merged', async () => {
  const tab = await lidChosen();
  expect(step(tab)).toMatchObject({ id: 'merge 1', source: 'lid', target: 'bowl', boundaries: [] });
  expect(tab.app.state.tool.value).toBe('mark-region');
  expect(tab.mergeState.sides.value.source!.model.name).toBe('lid');
  expect(merged(tab)).toBeNull();
  tab.app.document.undo();
  expect(tab.app.state.workspace.value).toBe('deform');
});

test('one button joins two models of one opening each, and writes down what it found', async () => {
  const tab = await lidChosen();
  await tab.app.commands.run('merge.run');
  await tab.app.evaluator.settled();
  expect(merged(tab)).toMatchObject({ closed: true, eulerCharacteristic: 2 });
  expect(step(tab).boundaries.map(({ source, target }) => [source.length, target.length])).toEqual([
    [20, 31],
  ]);
  expect(tab.merge.joins.pins().length).toBeGreaterThan(0);
  expect(step(tab).boundaries[0]!.keys).toEqual([]);
  tab.app.document.undo();
  await tab.app.evaluator.settled();
  expect(merged(tab)).toBeNull();
  tab.app.document.redo();
  await tab.app.evaluator.settled();
  expect(merged(tab)).not.toBeNull();
});

test('a found pin that is moved is written into the recipe, and the merge follows', async () => {
  const tab = await lidChosen();
  await tab.app.commands.run('merge.run');
  await tab.app.evaluator.settled();
  const before = tab.app.evaluator.result.value!.positions;
  const [boundary] = tab.merge.joins.boundaries();
  const keys: [number, number][] = boundary!.keys.map(([s, t]) => [(s + 5) % 20, t]);
  tab.merge.joins.setBoundaries('Move', [{ ...boundary!, keys }], 0);
  await tab.app.evaluator.settled();
  expect(step(tab).boundaries[0]!.keys).toEqual(keys);
  expect(tab.app.evaluator.result.value!.positions).not.toEqual(before);
  tab.merge.joins.removePin(0);
  expect(step(tab).boundaries[0]!.keys).toHaveLength(keys.length - 1);
});

test('two openings picked by hand are a pair; picking the same one again lets it go', async () => {
  const tab = await lidChosen();
  const { merge } = tab;
  const loop = (side: 'source' | 'target'): Loop => merge.aids.of(side)!.loops[0]!;
  merge.joins.pickLoop('target', loop('target'));
  expect(tab.mergeState.picked.value?.side).toBe('target');
  merge.joins.pickLoop('target', loop('target'));
  expect(tab.mergeState.picked.value).toBeNull();
  merge.joins.pickLoop('target', loop('target'));
  merge.joins.pickLoop('source', loop('source'));
  await tab.app.evaluator.settled();
  expect(tab.mergeState.picked.value).toBeNull();
  expect(merged(tab)).toMatchObject({ closed: true });
  merge.joins.removePair(0);
  await tab.app.evaluator.settled();
  expect(merged(tab)).toBeNull();
});

test('what is merged can be exported, deformed, and merged again', async () => {
  const tab = await lidChosen();
  await tab.app.commands.run('merge.run');
  await tab.app.evaluator.settled();
  for (const format of ['obj', 'ply', 'stl', 'glb'] as const) await tab.app.files.exportModel(format);
  expect(tab.saved.map(({ bytes }) => bytes.length > 1000)).toEqual([true, true, true, true]);
  await tab.app.commands.run('merge.another');
  expect(tab.app.state.choosing.value).not.toBeNull();
  tab.merge.part.cancel();
  await tab.app.commands.run('merge.deform');
  await tab.app.evaluator.settled();
  expect(tab.app.state.step.value).toMatchObject({ id: 'deform 2', model: 'merge 1' });
  expect(tab.app.state.facts.value).toMatchObject({ closed: true });
  await tab.app.commands.run('workspace.merge');
  expect(step(tab).id).toBe('merge 1');
});

test('a dropped file becomes the part while one is asked for, and a link needs only gallery models', async () => {
  const tab = await bowlOpen();
  await tab.app.commands.run('workspace.merge');
  await tab.app.files.openFiles([file('my lid.obj', LID)]);
  await tab.app.evaluator.settled();
  expect(step(tab)).toMatchObject({ source: 'my lid', target: 'bowl' });
  expect(await tab.app.share.link()).toMatchObject({ kind: 'needs-file' });
});

test('another part keeps what is marked on the target', async () => {
  const tab = await lidChosen();
  tab.merge.marking.setMark('target', Uint32Array.from([0, 1, 2]), 'Mark');
  await tab.app.commands.run('merge.part');
  tab.app.state.choosing.value!.choose('lid 2', { builtin: 'lid' });
  expect(step(tab)).toMatchObject({ id: 'merge 1', source: 'lid 2' });
  expect(tab.merge.marking.markSize('target')).toBe(3);
  expect(Object.keys(tab.app.document.recipe.models)).toEqual(['bowl', 'lid 2']);
});

test('marks that cannot be joined are told in words that say what to do, and nothing is lost', async () => {
  const tab = await lidChosen();
  const { evaluator, document } = tab.app;
  const { merge } = tab;
  const vertices = (from: number, to: number) => Uint32Array.from({ length: to - from }, (_, i) => from + i);
  merge.marking.setMark('source', vertices(120, 241), 'Mark');
  merge.marking.setMark('feature', vertices(100, 241), 'Mark');
  merge.marking.setMark('target', vertices(200, 373), 'Mark');
  const before = document.recipe;
  // Without the button's tidying.
  tab.mergeState.letGo();
  await evaluator.settled();
  expect(tab.mergeState.problem.value).toContain('yellow');
  expect(merged(tab)).toBeNull();
  expect(document.recipe).toBe(before);
  await tab.app.commands.run('merge.run');
  await evaluator.settled();
  // The button takes the yellow mark into the red one: all that was painted is still there, and still no ring around it.
  expect(tab.mergeState.problem.value).toContain('yellow');
  expect(merged(tab)).toBeNull();
  expect((['source', 'feature', 'target'] as const).map((mark) => merge.marking.markSize(mark))).toEqual([
    141, 141, 173,
  ]);
  document.undo();
  expect(document.recipe).toBe(before);
});

test('stopping a merge leaves its button to begin again', async () => {
  const tab = await lidChosen();
  await tab.app.commands.run('merge.run');
  await tab.app.evaluator.settled();
  tab.mergeState.hold('merge 1');
  await tab.app.evaluator.settled();
  expect(merged(tab)).toBeNull();
  await tab.app.commands.run('merge.run');
  await tab.app.evaluator.settled();
  expect(merged(tab)).not.toBeNull();
});

test('widths of the overlap are parts of the loops’ lengths, and go with the loops', async () => {
  const tab = await lidChosen();
  await tab.app.commands.run('merge.run');
  tab.merge.shape.setTransition({ source: 0.1, target: 0.05 });
  await tab.app.evaluator.settled();
  expect(tab.merge.shape.transitionShares().source).toBeCloseTo(0.1, 3);
  expect(tab.merge.shape.transitionShares().target).toBeCloseTo(0.05, 3);
  tab.merge.joins.removePair(0);
  expect(step(tab).transition).toBeUndefined();
});

test('merged in place, the part stands where the numbers put it', async () => {
  const tab = await lidChosen();
  await tab.app.commands.run('merge.run');
  tab.merge.shape.setMode('dependent');
  // At first over the target's opening, as large as that.
  const [size] = tab.merge.shape.pose().scale;
  expect(size).toBeCloseTo(1.4, 1);
  const top = async (y: number): Promise<number> => {
    tab.merge.shape.setPose({ translation: [0, y, 0] }, true);
    tab.merge.edits.finish();
    await tab.app.evaluator.settled();
    expect(tab.mergeState.problem.value).toBeNull();
    const { positions } = tab.app.evaluator.result.value!;
    return Math.max(...positions.filter((_, i) => i % 3 === 1));
  };
  const low = await top(0);
  expect(tab.merge.shape.reach()).toBeLessThanOrEqual(0.3);
  expect(await top(2)).toBeCloseTo(low + 2, 9);
  expect(tab.merge.shape.pose().translation).toEqual([0, 2, 0]);
});

// Where two models meet, from what is marked.

const part = (marks: object, hole?: (x: number, y: number) => boolean) => {
  const surface = sheet(12, 12, hole);
  const loopsAround = async (set: Uint32Array) => [set.slice(0, 4), set.slice(0, 3)];
  return { ...surface, graph: new MeshGraph(surface), loops: [], marks, loopsAround };
};
const square = Uint32Array.from({ length: 25 }, (_, i) => 12 * (3 + Math.floor(i / 5)) + 3 + (i % 5));

test('two patches meet along the line that is sought; the middle of the part is carried over', async () => {
  const found = await meetingOf(part({ source: square }), part({ target: square }), false);
  expect(found.kind).toBe('optimal');
  if (found.kind !== 'optimal') return;
  expect(found.marks.feature).toContain(12 * 5 + 5);
  expect(found.marks.source).toEqual(square);
});

test('or along the edges of the patches: the part keeps its inside, the target what is outside', async () => {
  const found = await meetingOf(part({ source: square }), part({ target: square }), true);
  expect(found).toMatchObject({
    kind: 'loops',
    boundaries: [{ source: [...square.slice(0, 4)], target: [...square.slice(0, 4)].reverse() }],
  });
});

test('a model that is not marked is named', async () => {
  const code = (promise: Promise<unknown>) =>
    promise.then(
      () => '',
      (error: unknown) => (error instanceof LissomError ? error.code : String(error)),
    );
  expect(await code(meetingOf(part({}), part({}), false))).toBe('merge-unmarked');
  expect(await code(meetingOf(part({}), part({ target: square }), false))).toBe('merge-unmarked-source');
  expect(await code(meetingOf(part({ source: square }), part({}), false))).toBe('merge-unmarked-target');
});
