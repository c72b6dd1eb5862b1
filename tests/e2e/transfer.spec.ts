import type { TransferWing } from '../../web/app/transfer/wing';
import { toIndices } from '../../web/core/vertex-set';
import { diagonal, expect, gap, SIZE, test, visitorAt } from './desk';
import { ballOf, chooseTarget, spotOnSource, transferred } from './transfer-desk';

test.slow();
test.use({ viewport: SIZE });

test('a dinosaur’s pose is given to a horse: chosen, paired, followed live, undone, and sent as a link', async ({
  fresh: desk,
  browser,
}) => {
  const { page } = desk;
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const head = await desk.grip(0);
  await desk.drag(head, { x: 120, y: 90 });
  await chooseTarget(desk, 'Horse');
  await desk.picture('transfer-start');
  const start = await transferred(desk);
  expect(start.step).toMatchObject({ model: 'horse', like: 'deform 1', handles: [[], []] });
  expect(start.selected).toBe(0);
  expect(gap(start.positions, start.rest)).toBe(0);

  const parts = [ballOf(start, [0, 1.98, 1.35], 0.2), ballOf(start, [0, 0.66, -1.14], 0.16)] as const;
  /** Clicks a handle of the dinosaur, then presses and moves over the part of the horse that matches. */
  const pair = async (handle: 0 | 1) => {
    const source = await spotOnSource(page, handle);
    await page.mouse.click(source.x, source.y);
    await desk.settled();
    expect((await transferred(desk)).selected).toBe(handle);
    const { positions } = await transferred(desk);
    const spot = await desk.spot(await desk.reachable([...parts[handle]], positions.length / 3));
    await desk.drag(spot, { x: 6, y: 3 });
  };

  await test.step('one pair says where, and that one more is needed', async () => {
    await expect(page.getByText('Mark here what matches Head')).toBeVisible();
    await pair(0);
    const { step, open, positions, rest, figures } = await transferred(desk);
    expect(open).toEqual([1]);
    const marked = toIndices(step.handles[0]!, rest.length / 3);
    expect(marked.length).toBeGreaterThan(20);
    // Marked where the pointer was: at the head.
    for (const v of marked) expect(rest[3 * v + 1]!).toBeGreaterThan(1.5);
    expect(figures).toBeNull();
    expect(gap(positions, rest)).toBe(0);
    await expect(page.getByText('Mark one more pair, and the pose is given')).toBeVisible();
  });

  await test.step('with the second the horse follows', async () => {
    await pair(1);
    const { open, positions, rest, figures, problem } = await transferred(desk);
    expect([open, problem]).toEqual([[], null]);
    expect(figures!.unknowns).toBeGreaterThan(0);
    expect(positions.every(Number.isFinite)).toBe(true);
    expect(gap(positions, rest)).toBeGreaterThan(0.03 * diagonal(rest));
    await desk.picture('transfer-given');
  });
  const given = await transferred(desk);

  await test.step('the strength is a slider, and one step of undo', async () => {
    const { index } = await desk.history();
    const slider = page.getByRole('slider', { name: 'Strength' });
    const box = (await slider.boundingBox())!;
    const y = box.y + box.height / 2;
    await desk.drag({ x: box.x + box.width / 2, y }, { x: -box.width / 4, y: 0 });
    const half = await transferred(desk);
    expect(half.step.strength).toBeGreaterThan(0.3);
    expect(half.step.strength).toBeLessThan(0.7);
    expect(gap(half.positions, half.rest)).toBeLessThan(gap(given.positions, given.rest));
    expect((await desk.history()).index).toBe(index + 1);
    await desk.press('Control+z');
    expect(gap((await transferred(desk)).positions, given.positions)).toBe(0);
  });

  await test.step('both are looked at as they are at rest', async () => {
    await desk.press('t');
    expect(gap((await transferred(desk)).positions, given.rest)).toBe(0);
    await desk.press('t');
    expect(gap((await transferred(desk)).positions, given.positions)).toBe(0);
  });

  await test.step('another visitor gets the same from the link', async () => {
    const link = await desk.copiedLink();
    await page.keyboard.press('Escape');
    const visitor = await visitorAt(browser, link);
    const seen = await transferred(visitor);
    expect(seen.step).toEqual(given.step);
    expect(gap(seen.positions, given.positions)).toBe(0);
    await visitor.page.context().close();
  });

  await test.step('the result is deformed further, and the transfer is still there', async () => {
    await page.getByRole('button', { name: 'Deform the result' }).click();
    await desk.settled();
    const { step, rest } = await desk.shown();
    expect(step).toMatchObject({ id: 'deform 2', model: 'transfer 1' });
    expect(gap(rest, given.positions)).toBe(0);
    await page.getByRole('navigation').getByRole('button', { name: 'Transfer', exact: true }).click();
    expect((await transferred(desk)).step.id).toBe('transfer 1');
  });

  await test.step('every stroke is undone', async () => {
    const paired = () =>
      page.evaluate(() => {
        const { state } = window.__lissom.app.wings.get('transfer') as TransferWing;
        return JSON.stringify(
          state.step.peek()?.handles.map((set) => set !== 'all' && 'length' in set && set.length === 0),
        );
      });
    let seen = '';
    while ((await desk.history()).index > 0) {
      await desk.press('Control+z');
      seen += `${await paired()} `;
    }
    expect(seen).toContain('[false,true] [true,true]');
    await expect(page.getByRole('navigation').getByRole('button', { name: 'Deform' })).toHaveAttribute(
      'aria-pressed',
      'true',
    );
  });
});

test('without a pose the workspace says what is missing', async ({ desk }) => {
  const { page } = desk;
  // The first of the shared page's documents has two handles; without them there is nothing to give.
  for (const _ of [0, 1]) {
    await page
      .getByRole('button', { name: /^Delete / })
      .first()
      .click();
    await desk.settled();
  }
  await page.getByRole('navigation').getByRole('button', { name: 'Transfer', exact: true }).click();
  await desk.settled();
  expect(await desk.toast()).toContain('There is no pose to give yet');
});
