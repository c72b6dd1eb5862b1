import type { DeformWing } from '../../web/app/deform/wing';
import type { IsolineMotion } from '../../web/view/deform/isoline-motion';
import { blended } from '../view/deform/isoline-reference';
import { type Desk, diagonal, expect, gap, handleGap, moved, SIZE, test } from './desk';
import { pictureTimes } from './picture-times';
import { rolledObj, sheetRecipe } from './shapes';

test.use({ viewport: SIZE });

const state = (desk: Desk) =>
  desk.page.evaluate(() => {
    const { moved, settled } = window.__lissom.app.evaluator.result.peek()!;
    return { movable: moved !== null, settled };
  });

/** What the graphics card has made of the model, and what it was given to make it of. */
async function onTheCard(desk: Desk) {
  const read = await desk.page.evaluate(() => {
    const { evaluator, wings } = window.__lissom.app;
    const { moved, shown } = evaluator.result.peek()!;
    const wing = wings.get('deform') as unknown as DeformWing;
    const { fields, still, ...surface } = (moved!.motion as IsolineMotion).surface;
    return {
      ...{ sets: surface.sets, single: surface.single, basis: surface.basis, controls: surface.controls },
      fields: [...fields],
      still: [...(still ?? [])],
      offsets: [...moved!.table],
      rest: [...shown.model.positions],
      drawn: [...wing.state.readBack()!.positions],
    };
  });
  return {
    ...read,
    fields: Float32Array.from(read.fields),
    still: Uint8Array.from(read.still),
    offsets: Float64Array.from(read.offsets),
    rest: Float64Array.from(read.rest),
    drawn: Float64Array.from(read.drawn),
  };
}

test('a drag by isolines follows on the graphics card, settles when the hand lets go, and is a step of undo', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await page.getByLabel('Follow by').selectOption('isolines');
  await desk.settled();
  const rest = await desk.shown();
  const grip = await desk.grip(0);
  await page.mouse.move(grip.x, grip.y);
  await page.mouse.down();
  for (let i = 1; i <= 6; i++) await page.mouse.move(grip.x + 20 * i, grip.y - 5 * i);
  await desk.settled();
  expect(await state(desk)).toEqual({ movable: true, settled: false });
  await expect(page.getByText('Moving by isolines')).toBeVisible();
  const { drawn, offsets, rest: still, ...surface } = await onTheCard(desk);
  const apart = gap(drawn, blended(surface, offsets, still)) / diagonal(still);
  console.log(`graphics card and formula: ${apart.toExponential(1)} of the diagonal apart`);
  expect(apart).toBeLessThan(1e-4);
  await desk.picture('isolines-dragged');
  await page.mouse.up();
  await desk.settled();
  expect(await state(desk)).toEqual({ movable: false, settled: true });
  await desk.picture('isolines-settled');
  const posed = await desk.shown();
  expect(gap(posed.positions, rest.positions)).toBeGreaterThan(0);
  for (const view of ['lines', 'field', 'rigidity', 'nothing']) {
    await page.getByLabel('Show', { exact: true }).selectOption(view);
    await desk.settled();
    await desk.picture(`isolines-${view}`);
  }
  await desk.press('Control+z');
  expect(gap((await desk.shown()).positions, rest.positions)).toBe(0);
});

test('a large model is prepared with progress and a way out, and dragged by isolines whatever its method', async ({
  fresh: desk,
}) => {
  test.slow();
  const { page } = desk;
  const n = 412; // 170,569 vertices
  // Strips wide enough to take hold of.
  const recipe = sheetRecipe(n, 20, { method: 'isolines' });
  await desk.chooseAndCancel(['sheet.json', recipe], ['sheet.obj', rolledObj(n)]);

  await page.getByRole('button', { name: /^Left/ }).click();
  await page.getByRole('textbox', { name: 'Move Y' }).fill('9');
  await page.keyboard.press('Enter');
  const shown = await desk.shown();
  expect(shown.rest).toHaveLength(3 * (n + 1) ** 2);
  expect(moved(shown).length).toBeGreaterThan(1000);
  expect(handleGap(shown.step.handles[0]!, shown)).toBeLessThan(1e-9);

  await page.getByLabel('Follow by').selectOption('implicit');
  await desk.settled();
  await page.keyboard.press('Escape');
  const grip = await desk.grip(0);
  await page.mouse.move(grip.x, grip.y);
  await page.mouse.down();
  for (let i = 1; i <= 4; i++) await page.mouse.move(grip.x, grip.y - 12 * i);
  await desk.settled();
  expect(await state(desk)).toEqual({ movable: true, settled: false });
  await desk.picture('isolines-large');
  const { alone, moving } = await pictureTimes(desk);
  console.log(
    `a picture of 170,569 vertices: ${alone.toFixed(0)} ms alone, ${moving.toFixed(0)} ms moved by isolines first, ${(moving / alone).toFixed(2)} times`,
  );
  await page.mouse.up();
  await desk.settled();
  expect(await state(desk)).toEqual({ movable: false, settled: true });
});

test('the large model of the gallery is made when it is opened, and given up when it is cancelled', async ({
  fresh: desk,
}) => {
  test.slow();
  const { page } = desk;
  const before = await desk.shown();
  await page.keyboard.press('Control+g');
  const card = page.getByRole('button', { name: /^Critter with scales/ });
  await expect(card).toContainText('476,482 vertices · made when opened');
  await card.click();
  const sign = page.locator('.status-busy');
  await expect(sign).toContainText(/Making Critter with scales|Opening Critter with scales/, {
    timeout: 60_000,
  });
  await sign.getByRole('button', { name: 'Cancel' }).click();
  await expect(sign).toBeHidden();
  await desk.settled();
  expect(await page.locator('.toast.bad').count()).toBe(0);
  const after = await desk.shown();
  expect(after.rest).toEqual(before.rest);
  // Nothing of it is left in the way.
  await page.keyboard.press('Control+g');
  await page.getByRole('button', { name: 'Bar, 10 straight controls' }).click();
  await expect.poll(() => page.title(), { timeout: 60_000 }).toContain('Bar, 10 straight controls');
  await desk.settled();
  expect(handleGap((await desk.shown()).step.handles[1]!, await desk.shown())).toBeLessThan(1e-9);
});
