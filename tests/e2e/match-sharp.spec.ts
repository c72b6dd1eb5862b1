// Sharp edges in the match workspace: seen by their angle, picked and left by the pointer; and a pose that is given first.

import type { MatchWing } from '../../web/app/match/wing';
import type { Vec3 } from '../../web/view/types';
import { type Desk, expect, type Place, test } from './desk';
import { matched, shownModels } from './match-desk';
import { barObj } from './shapes';

test.slow();
test.use({ viewport: { width: 1440, height: 900 } });

/** Of the bars' edges: which are creases is known. */
const LONG = barObj(8, 3);
const SHORT = barObj(6, 3);

async function chooseBars(desk: Desk): Promise<void> {
  const { page } = desk;
  await desk.choose(['long.obj', LONG]);
  await page.getByRole('navigation').getByRole('button', { name: 'Match', exact: true }).click();
  await expect(page.getByRole('heading', { name: 'Choose a model to match' })).toBeVisible();
  await desk.choose(['short.obj', SHORT]);
  await shownModels(desk, 2);
}

/** On the page: a point of one of the two models. */
const placeOf = (desk: Desk, at: 0 | 1, point: Vec3): Promise<Place> =>
  desk.page.evaluate(
    ([number, place]) => {
      const { app } = window.__lissom;
      const view = number === 0 ? app.viewport! : app.panes.all.peek()[0]!.viewport;
      const canvas =
        number === 0
          ? document.querySelector('.stage > .viewport canvas')!
          : document.querySelectorAll('.match-cell')[1]!.querySelector('canvas')!;
      const box = canvas.getBoundingClientRect();
      const seen = view.project(place);
      return { x: box.left + seen.x, y: box.top + seen.y };
    },
    [at, point] as const,
  );

const kept = (desk: Desk) =>
  desk.page.evaluate(() => {
    const { state } = window.__lissom.app.wings.get('match') as MatchWing;
    return state.kept.peek().map(({ length }) => length);
  });

test('sharp edges are seen by their angle, picked, gone on with, left and undone', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await chooseBars(desk);

  await test.step('a click takes an edge as far as it runs', async () => {
    await page.keyboard.press('s');
    const { x, y } = await placeOf(desk, 0, [4.5, 3, 3]);
    await page.mouse.move(x + 3, y + 3);
    await page.waitForTimeout(200);
    await desk.picture('sharp-hover');
    await page.mouse.click(x, y + 3);
    const { step } = await matched(desk);
    expect(step.sharp).toHaveLength(2);
    expect(step.sharp![0]).toHaveLength(1);
    expect(step.sharp![0]![0]).toHaveLength(9);
    expect(step.sharp![1]).toEqual([]);
    await expect(page.getByRole('list', { name: 'Picked edges' })).toContainText('Sharp edge 1');
  });

  await test.step('a drag takes a path along edges, over a smooth side, too', async () => {
    const from = await placeOf(desk, 1, [1, 2, 3]);
    const to = await placeOf(desk, 1, [4, 2, 3]);
    await desk.drag(from, { x: to.x - from.x, y: to.y - from.y }, 12);
    const { step } = await matched(desk);
    expect(step.sharp![1]).toHaveLength(1);
    expect(step.sharp![1]![0]).toHaveLength(4);
  });

  await test.step('Shift goes on from there', async () => {
    const end = await placeOf(desk, 1, [6, 2, 3]);
    await page.keyboard.down('Shift');
    await page.mouse.click(end.x - 2, end.y);
    await page.keyboard.up('Shift');
    expect((await matched(desk)).step.sharp![1]![0]).toHaveLength(6);
    await desk.picture('sharp-picked');
  });

  await test.step('what an angle keeps is drawn before anything is matched', async () => {
    await page.getByText('Advanced').click();
    await page.getByLabel('Keep sharp edges').click();
    await page.waitForFunction(() => {
      const { state } = window.__lissom.app.wings.get('match') as MatchWing;
      return state.kept.peek().length === 2;
    });
    expect(await kept(desk)).toEqual([12, 12]);
    await expect(page.getByText('long: 12 edges found')).toBeVisible();
    await desk.picture('sharp-angle');
    await page.setViewportSize({ width: 860, height: 700 });
    await page.waitForTimeout(400);
    await desk.picture('sharp-angle-small');
    await page.setViewportSize({ width: 1440, height: 900 });
    await page.waitForTimeout(400);
  });

  await test.step('a click on a picked edge leaves it; the list and undo do so, too', async () => {
    const { x, y } = await placeOf(desk, 0, [4.5, 3, 3]);
    await page.mouse.click(x, y + 3);
    expect((await matched(desk)).step.sharp![0]).toEqual([]);
    await desk.press('Control+z');
    expect((await matched(desk)).step.sharp![0]).toHaveLength(1);
    await page.getByRole('button', { name: 'Remove Sharp edge 1' }).last().click();
    expect((await matched(desk)).step.sharp![1]).toEqual([]);
    await desk.press('Control+z');
  });

  await test.step('they are kept by the match', async () => {
    await page
      .getByRole('button', { name: /^Match( again)?$/ })
      .last()
      .click();
    const { problem, skin } = await matched(desk);
    expect(problem).toBeNull();
    expect(skin).toBeGreaterThan(50);
    await desk.picture('sharp-matched');
  });

  await test.step('a model is posed first, and what comes of it is matched in its place', async () => {
    await page.getByRole('button', { name: 'More about short' }).click();
    await desk.picture('pose-menu');
    await page.getByRole('menuitem', { name: 'Pose it first by handles' }).click();
    await desk.settled();
    expect((await desk.shown()).step).toMatchObject({ type: 'deform', model: 'short' });
    await desk.picture('pose-first');
    await page.getByRole('navigation').getByRole('button', { name: 'Match', exact: true }).click();
    await shownModels(desk, 2);
    const { step } = await matched(desk);
    expect(step.models[0]).toBe('long');
    expect(step.models[1]).toMatch(/^deform/);
    expect(step.sharp![1]).toHaveLength(1);
    await desk.picture('pose-back');
  });
});
