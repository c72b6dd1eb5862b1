import { expect, gap, handleGap, moved, test } from './desk';
import { sheetObj, sheetRecipe } from './shapes';

test('a lost graphics card comes back with the picture, and the work was never at risk', async ({ desk }) => {
  const { page } = desk;
  await desk.drag(await desk.grip(1), { x: -30, y: -70 });
  const before = await desk.shown();
  const colours = await desk.colours();
  await page.evaluate(async () => {
    const lost = document.querySelector('canvas')!.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    lost.loseContext();
    await new Promise((done) => setTimeout(done, 200));
    lost.restoreContext();
  });
  await expect(page.getByText(/graphics card was reset/)).toBeVisible();
  expect(gap((await desk.shown()).positions, before.positions)).toBe(0);
  await expect.poll(() => desk.colours()).toBeGreaterThan(0.7 * colours);
  await desk.drag(await desk.grip(1), { x: 20, y: 20 });
  expect(gap((await desk.shown()).positions, before.positions)).toBeGreaterThan(0.01);
  await desk.picture('context-restored');
});

test('after the worker died the next edit is computed by a new one', async ({ desk }) => {
  const { page } = desk;
  await desk.drag(await desk.grip(1), { x: -30, y: -70 });
  const before = await desk.shown();
  const [worker] = page.workers();
  await worker!.evaluate(() => {
    setTimeout(() => {
      throw new Error('died for a test');
    });
  });
  await page.waitForTimeout(100);
  await desk.drag(await desk.grip(1), { x: 20, y: 30 });
  const after = await desk.shown();
  expect(gap(after.positions, before.positions)).toBeGreaterThan(0.01);
  for (const handle of after.step.handles) expect(handleGap(handle, after)).toBeLessThan(1e-5);
  await desk.press('Control+z');
  expect(gap((await desk.shown()).positions, before.positions)).toBeLessThan(1e-9);

  await test.step('even where it died without a word', async () => {
    await page.workers()[0]!.evaluate(() => self.close());
    await desk.press('Control+Shift+Z');
    expect(gap((await desk.shown()).positions, after.positions)).toBeLessThan(1e-9);
    await desk.drag(await desk.grip(1), { x: 10, y: 10 });
    const again = await desk.shown();
    expect(gap(again.positions, after.positions)).toBeGreaterThan(0.01);
  });
});

test('a long factorization can be cancelled, and the page goes on', async ({ desk }) => {
  test.slow();
  const { page } = desk;
  const n = 245;
  const options = { coherenceRing: 2 };
  await desk.chooseAndCancel(['sheet.json', sheetRecipe(n, 1, { options })], ['sheet.obj', sheetObj(n)]);

  await page.getByRole('button', { name: /^Left/ }).click();
  await page.getByRole('textbox', { name: 'Move Y' }).fill('9');
  await page.keyboard.press('Enter');
  const shown = await desk.shown();
  expect(shown.rest).toHaveLength(3 * (n + 1) ** 2);
  expect(moved(shown).length).toBeGreaterThan(1000);
  expect(handleGap(shown.step.handles[0]!, shown)).toBeLessThan(1e-4);
  await desk.picture('large');
});
