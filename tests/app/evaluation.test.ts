import { expect, test, vi } from 'vitest';
import { LissomError } from '../../web/core/errors';
import { Tab } from './world';

async function ready() {
  const tab = new Tab();
  await tab.openCube();
  await tab.addHandle([0, 1], 'Low');
  await tab.addHandle([6, 7], 'High');
  return tab;
}

test('of many moves only the first and the newest are computed', async () => {
  const tab = await ready();
  const { evaluator } = tab.app;
  const { deform } = tab;
  tab.kernel.calls.length = 0;
  let release = () => {};
  tab.kernel.before = () => new Promise((done) => (release = done));
  for (let x = 1; x <= 10; x++) {
    deform.setPose(0, { translation: [x, 0, 0] }, true);
    await vi.waitFor(() => expect(tab.kernel.calls.length).toBeGreaterThan(0));
  }
  tab.kernel.before = async () => {};
  release();
  await evaluator.settled();
  expect(tab.kernel.calls.filter((call) => call === 'deform')).toHaveLength(2);
  expect(evaluator.result.value?.positions[0]).toBe(10);
});

test('a drag does not factor anew', async () => {
  const tab = await ready();
  tab.kernel.calls.length = 0;
  for (let x = 1; x <= 5; x++) {
    tab.deform.setPose(0, { translation: [x, 0, 0] }, true);
    await tab.app.evaluator.settled();
  }
  expect(tab.kernel.calls).not.toContain('prepareDeform');
});

test('while a solve is slow the drag shows the first solve only, and settles on release', async () => {
  const tab = await ready();
  const { evaluator } = tab.app;
  const { deform } = tab;
  tab.kernel.solveSeconds = 0.5;
  deform.setPose(0, { translation: [1, 0, 0] });
  await evaluator.settled();
  tab.kernel.settles.length = 0;
  deform.setPose(0, { translation: [2, 0, 0] }, true);
  await evaluator.settled();
  deform.finish();
  await evaluator.settled();
  expect(tab.kernel.settles).toEqual([false, true]);
  expect(evaluator.result.value?.settled).toBe(true);
});

test('a step without handles shows its input and asks for no solve', async () => {
  const tab = new Tab();
  await tab.openCube();
  expect(tab.kernel.calls).not.toContain('prepareDeform');
  expect(tab.app.state.facts.value).toMatchObject({ vertices: 8, faces: 12, closed: true });
  expect(tab.app.state.figures.value.solve).toBeNull();
});

test('a failure is said in a sentence and the next edit is computed again', async () => {
  const tab = await ready();
  const { evaluator } = tab.app;
  const { deform } = tab;
  tab.kernel.before = async (method) => {
    if (method === 'deform') throw new LissomError('solver', 'The region is too thin to solve.', 'solver');
  };
  deform.setPose(0, { translation: [1, 0, 0] });
  await evaluator.settled();
  expect(tab.toasts).toContain('The region is too thin to solve.');
  tab.kernel.before = async () => {};
  deform.setPose(0, { translation: [2, 0, 0] });
  await evaluator.settled();
  expect(evaluator.result.value?.positions[0]).toBe(2);
});

test('after an edit it is told what it did', async () => {
  const tab = await ready();
  tab.deform.setPose(0, { translation: [3, 0, 0] });
  await tab.app.evaluator.settled();
  await vi.waitFor(() =>
    expect(tab.deformState.whatItDid.value).toMatchObject({
      worstStretch: 0.25,
      handlesMet: 2,
      handles: 2,
      closed: true,
    }),
  );
});

test('long work shows progress and a way out, and cancelling says nothing', async () => {
  const tab = await ready();
  const { evaluator, state } = tab.app;
  const { deform } = tab;
  let release = () => {};
  tab.kernel.before = () => new Promise((done) => (release = done));
  deform.setOptions({ coherenceRing: 2 });
  await vi.waitFor(() => expect(state.busy.value).not.toBeNull());
  state.busy.value?.cancel?.();
  release();
  await evaluator.settled();
  expect(state.busy.value).toBeNull();
  expect(tab.toasts).toEqual([]);
});
