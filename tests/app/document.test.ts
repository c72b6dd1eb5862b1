import { expect, test } from 'vitest';
import { withPose } from '../../web/app/deform/actions';
import type { DeformHandle } from '../../web/recipe/recipe';
import { Tab } from './world';

async function cubeWithHandles() {
  const tab = new Tab();
  await tab.openCube();
  await tab.addHandle([0, 1], 'Low');
  await tab.addHandle([6, 7], 'High');
  return tab;
}
const positions = (tab: Tab) => [...tab.app.evaluator.result.value!.positions];

test('a typed-in move shows, is one step of undo, and undo brings the shape back', async () => {
  const tab = await cubeWithHandles();
  const { app } = tab;
  const before = positions(tab);
  tab.deform.setPose(0, { translation: [5, 0, 0] });
  await app.evaluator.settled();
  expect(positions(tab)[0]).toBe(5);
  expect(tab.deform.pose(0)?.translation).toEqual([5, 0, 0]);
  app.document.undo();
  await app.evaluator.settled();
  expect(positions(tab)).toEqual(before);
});

test('numbers typed in quick succession are one step of undo', async () => {
  const tab = await cubeWithHandles();
  const { document } = tab.app;
  const { deform } = tab;
  const steps = document.entries.length;
  for (const x of [1, 12, 12.5]) deform.setPose(0, { translation: [x, 0, 0] });
  expect(document.entries).toHaveLength(steps + 1);
  expect(deform.pose(0)?.translation).toEqual([12.5, 0, 0]);
});

test('turning by 90 degrees keeps the middle of the handle where it is', async () => {
  const { deform } = await cubeWithHandles();
  deform.setPose(0, { rotation: [0, 0, 90] });
  expect(deform.pose(0)?.rotation.map((a) => Math.round(a * 1e9) / 1e9)).toEqual([0, 0, 90]);
  expect(deform.pose(0)?.translation).toEqual([0, 0, 0]);
});

test('a pure move keeps a shear that the matrix has', () => {
  const sheared: DeformHandle = {
    kind: 'region',
    vertices: [0],
    matrix: [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  };
  const moved = withPose(sheared, new Float64Array(3), { translation: [1, 2, 3] });
  expect(moved).toMatchObject({ matrix: [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1] });
});

test('numbers that are not finite are ignored', async () => {
  const tab = await cubeWithHandles();
  const { document } = tab.app;
  const { deform } = tab;
  const { recipe } = document;
  deform.setPose(0, { translation: [Number.NaN, 0, 0] });
  expect(document.recipe).toBe(recipe);
});

test('a live preview that is cancelled leaves no trace', async () => {
  const tab = await cubeWithHandles();
  const { document, evaluator, state } = tab.app;
  const { deform } = tab;
  const { recipe } = document;
  const before = positions(tab);
  deform.setPose(0, { translation: [3, 0, 0] }, true);
  expect(state.previewing.value).toBe(true);
  await evaluator.settled();
  deform.cancel();
  await evaluator.settled();
  expect(state.previewing.value).toBe(false);
  expect(document.recipe).toBe(recipe);
  expect(positions(tab)).toEqual(before);
});

test('selecting is undoable', async () => {
  const { document, state } = (await cubeWithHandles()).app;
  document.select(0);
  expect(state.selection.value.item).toBe(0);
  document.undo();
  expect(state.selection.value.item).toBe(1);
});

test('selecting after an undo does not throw away what redo would bring back', async () => {
  const tab = await cubeWithHandles();
  const { document, state } = tab.app;
  const { deform } = tab;
  deform.setPose(0, { translation: [5, 0, 0] });
  document.undo();
  document.select(0);
  expect(state.selection.value.item).toBe(0);
  expect(state.canRedo.value).toBe(true);
  document.redo();
  expect(deform.pose(0)?.translation).toEqual([5, 0, 0]);
});

test('"apply and continue" starts a new step on the result of the last', async () => {
  const tab = await cubeWithHandles();
  const { document, evaluator, state } = tab.app;
  const { deform } = tab;
  deform.setPose(0, { translation: [5, 0, 0] });
  deform.setOptions({ removeShear: false });
  deform.applyAndContinue();
  await evaluator.settled();
  expect(document.recipe.steps.map((step) => [step.id, 'model' in step ? step.model : ''])).toEqual([
    ['deform 1', 'cube'],
    ['deform 2', 'deform 1'],
  ]);
  expect(deform.step?.options.removeShear).toBe(false);
  expect(positions(tab)[0]).toBe(5);
  expect(state.selection.value).toEqual({ step: 'deform 2', item: null });
});

test('an earlier step can be opened again, and what was built on it follows', async () => {
  const tab = await cubeWithHandles();
  const { document, evaluator } = tab.app;
  const { deform } = tab;
  deform.setPose(0, { translation: [5, 0, 0] });
  deform.applyAndContinue();
  document.openStep('deform 1');
  await evaluator.settled();
  deform.setPose(0, { translation: [7, 0, 0] });
  document.openStep('deform 2');
  await evaluator.settled();
  expect(positions(tab)[0]).toBe(7);
});

test('a step put between two others takes the later one with it', async () => {
  const tab = await cubeWithHandles();
  const { document } = tab.app;
  const { deform } = tab;
  deform.applyAndContinue();
  document.openStep('deform 1');
  deform.applyAndContinue();
  expect(document.recipe.steps.map((step) => [step.id, 'model' in step ? step.model : ''])).toEqual([
    ['deform 1', 'cube'],
    ['deform 3', 'deform 1'],
    ['deform 2', 'deform 3'],
  ]);
});

test('a step that is removed leaves the rest in order', async () => {
  const tab = await cubeWithHandles();
  const { document } = tab.app;
  const { deform } = tab;
  deform.applyAndContinue();
  document.removeStep('deform 2');
  expect(document.recipe.steps).toHaveLength(1);
  expect(document.selection.step).toBe('deform 1');
});
