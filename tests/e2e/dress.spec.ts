import type { DressWing } from '../../web/app/dress/wing';
import type { DressStep } from '../../web/recipe/recipe';
import { serious } from './axe';
import { bytesOf, type Desk, expect, gap, test } from './desk';
import { FIGURE_FILES, MATCHED, SLEEVE } from './figures';

test.slow();
test.use({ viewport: { width: 1240, height: 860 } });

interface Worn {
  readonly step: DressStep;
  readonly rest: Float64Array;
  readonly positions: Float64Array;
  readonly wearer: string | undefined;
  readonly figures: { readonly before: number; readonly after: number } | null;
  readonly problem: string | null;
  readonly others: readonly string[];
}

async function worn(desk: Desk): Promise<Worn> {
  await desk.settled();
  const read = await desk.page.evaluate(() => {
    const { app } = window.__lissom;
    const { state } = app.wings.get('dress') as DressWing;
    const { shown, positions, wearer } = app.evaluator.result.peek()!;
    return {
      step: JSON.stringify(state.step.peek()),
      rest: [...shown.model.positions],
      positions: [...positions],
      wearer: wearer?.model.name,
      figures: state.figures.peek(),
      problem: state.problem.peek(),
      others: state.others.peek().map(({ id }) => id),
    };
  });
  return {
    ...read,
    step: JSON.parse(read.step) as DressStep,
    rest: Float64Array.from(read.rest),
    positions: Float64Array.from(read.positions),
  };
}

/** Mean distance from the upright axis. */
const girth = (positions: Float64Array): number => {
  let sum = 0;
  for (let i = 0; i < positions.length; i += 3) sum += Math.hypot(positions[i]!, positions[i + 2]!);
  return sum / (positions.length / 3);
};

/** Matched figures, and the sleeve chosen as what is worn. */
async function dress(desk: Desk): Promise<void> {
  const { page } = desk;
  await desk.choose(['figures.json', MATCHED], ...FIGURE_FILES);
  await page.getByRole('navigation').getByRole('button', { name: 'Dress', exact: true }).click();
  await expect(page.getByRole('heading', { name: 'Choose what is worn' })).toBeVisible();
  await desk.picture('dress-choose');
  const asked = page.waitForEvent('filechooser');
  await page.locator('.model-chooser').getByRole('button', { name: /file/ }).click();
  await (await asked).setFiles({
    name: 'sleeve.obj',
    mimeType: 'application/octet-stream',
    buffer: Buffer.from(SLEEVE),
  });
  await page.waitForFunction(() => {
    const wing = window.__lissom.app.wings.get('dress') as DressWing | undefined;
    return wing?.state.figures.peek() != null;
  });
}

test('a sleeve that was made for a slim figure is worn by a stout one', async ({ fresh: desk }) => {
  const { page } = desk;
  await dress(desk);
  const first = await worn(desk);
  expect(first.problem).toBeNull();
  expect(first.step).toMatchObject({ garment: 'sleeve', from: 'slim', to: 'stout' });
  expect(first.wearer).toBe('stout.obj');
  expect(first.figures!.after).toBe(0);
  expect(girth(first.positions)).toBeGreaterThan(1.15 * girth(first.rest));
  await expect(page.getByText('Places inside the body')).toBeVisible();
  await desk.picture('dress-worn');

  await test.step('the ease is a slider, and one step of undo', async () => {
    const { index } = await desk.history();
    const slider = (await page.getByRole('slider', { name: 'Ease' }).boundingBox())!;
    const y = slider.y + slider.height / 2;
    await desk.hold({ x: slider.x + slider.width / 5, y }, { x: slider.width / 2, y: 0 });
    await desk.settled();
    const live = await worn(desk);
    expect(live.step.offset).toBeGreaterThan(0);
    expect(girth(live.positions)).toBeGreaterThan(girth(first.positions));
    await page.mouse.up();
    const loose = await worn(desk);
    expect(loose.step.offset).toBe(live.step.offset);
    expect((await desk.history()).index).toBe(index + 1);
    await desk.press('Control+z');
    expect(gap((await worn(desk)).positions, first.positions)).toBe(0);
  });

  await test.step('where it lies off the body is coloured, and what it was is seen through it', async () => {
    await desk.press('t');
    await expect(page.getByText('Distance from the body')).toBeVisible();
    const range = await page.evaluate(() => {
      const { state } = window.__lissom.app.wings.get('dress') as DressWing;
      const { values } = state.clearance.peek()!;
      return values.reduce((least, each) => Math.min(least, each), Infinity);
    });
    expect(range).toBeGreaterThan(0);
    await desk.press('o');
    await desk.picture('dress-heat');
    await desk.press('t');
    await desk.press('o');
    await expect(page.getByText('Distance from the body')).toBeHidden();
  });

  await test.step('the next body gets it in a step of its own', async () => {
    await page.getByRole('button', { name: 'Fit it to the next body' }).click();
    const next = await worn(desk);
    expect(next.step).toMatchObject({ id: 'dress 2', to: 'tall' });
    expect(next.wearer).toBe('tall.obj');
    expect(next.figures!.after).toBe(0);
    await page.getByLabel('Worn by').selectOption('stout');
    const both = await worn(desk);
    expect(gap(both.positions, first.positions)).toBe(0);
    await expect.poll(async () => (await worn(desk)).others).toEqual(['dress 1']);
    await page.getByRole('button', { name: 'Take off sleeve' }).last().click();
    expect((await worn(desk)).step.id).toBe('dress 1');
  });

  await test.step('what is exported is the garment', async () => {
    await desk.press('Control+e');
    await page.getByRole('radio', { name: 'OBJ' }).check();
    const saved = page.waitForEvent('download');
    await page.getByRole('dialog').getByRole('button', { name: 'Export' }).click();
    const text = new TextDecoder().decode(await bytesOf(await saved));
    expect(text.split('\n').filter((line) => line.startsWith('v '))).toHaveLength(first.rest.length / 3);
  });
});

test('without a match the workspace says what is missing, and leads there', async ({ desk }) => {
  const { page } = desk;
  await page.getByRole('navigation').getByRole('button', { name: 'Dress', exact: true }).click();
  expect(await desk.toast()).toContain('There is nobody to dress yet');
  await expect(page.locator('.toast').getByRole('button', { name: 'Match bodies' })).toBeVisible();
});

test('axe finds nothing serious', async ({ fresh: desk }) => {
  await dress(desk);
  expect(await serious(desk)).toEqual([]);
});
