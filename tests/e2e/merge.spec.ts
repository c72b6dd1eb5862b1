import type { MergeWing } from '../../web/app/merge/wing';
import { readModel } from '../../web/io/formats';
import { writeModel } from '../../web/io/index';
import { bowl, dome, tube } from '../kernel/tubes';
import { bytesOf, diagonal, expect, gap, SIZE, test, visitorAt } from './desk';
import { choosePart, merged, pressMerge, spotOf, spots, strokeOver } from './merge-desk';

// Each on a page of its own.
test.describe.configure({ mode: 'parallel' });
test.slow();

test.describe('a horse’s head on a dinosaur', () => {
  test('is marked on both, merged with one button, refined, undone, and sent as a link', async ({
    fresh: desk,
    browser,
  }) => {
    const { page } = desk;
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await choosePart(desk, 'Horse');
    await desk.picture('merge-start');

    await test.step('a stroke over each model marks both of its sides', async () => {
      await strokeOver(desk, 'source', [
        [0, 2, 1.5],
        [0, 2.3, 1.05],
        [0, 1.85, 0.95],
        [0, 1.6, 0.75],
      ]);
      const horse = await marks('source');
      expect(horse.some((x) => x > 0.02) && horse.some((x) => x < -0.02)).toBe(true);
      await strokeOver(desk, 'target', [
        [0, 2.23, 1.85],
        [0, 2.35, 1.55],
        [0, 2, 1.35],
      ]);
      expect((await marks('target')).length).toBeGreaterThan(100);
      expect((await merged(desk)).figures).toBeNull();
      await desk.picture('merge-marked');
    });

    /** The x of each marked vertex. */
    async function marks(side: 'source' | 'target'): Promise<number[]> {
      return page.evaluate((pane) => {
        const { state } = window.__lissom.app.wings.get('merge') as MergeWing;
        const { positions } = state.sides.peek()[pane]!.model;
        const set = state.step.peek()!.optimalBoundary;
        const marked = pane === 'source' ? set?.sourceRegion : set?.targetRegion;
        const list =
          marked && typeof marked !== 'string' && 'ranges' in marked
            ? marked.ranges.flatMap(([a, b]) => Array.from({ length: b - a + 1 }, (_, i) => a + i))
            : [...((marked as readonly number[] | undefined) ?? [])];
        return list.map((v) => positions[3 * v]!);
      }, side);
    }

    await pressMerge(desk);
    const first = await merged(desk);
    expect(first.problem).toBeNull();
    expect(first.figures).toMatchObject({ closed: true, eulerCharacteristic: 2 });
    expect(first.figures!.energy.at(-1)!).toBeLessThan(first.figures!.energy[0]!);
    await desk.picture('merge-merged');

    await test.step('the line before the search is a key away', async () => {
      await desk.press('y');
      await expect(page.getByText('without the search')).toBeVisible();
      const before = await merged(desk);
      expect(before.recipe).toEqual(first.recipe);
      expect(before.figures!.energy).toHaveLength(1);
      await desk.press('y');
      expect(gap((await merged(desk)).positions, first.positions)).toBe(0);
    });

    await test.step('the part is turned in the picture of the maps', async () => {
      const maps = page.locator('canvas.maps');
      await maps.scrollIntoViewIfNeeded();
      const box = (await maps.boundingBox())!;
      const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
      await desk.drag(middle, { x: 12, y: 0 });
      const moved = await merged(desk);
      expect(moved.step.optimalBoundary!.placement).toBeDefined();
      expect(gap(moved.positions, first.positions)).toBeGreaterThan(0);
      await desk.picture('merge-placed');
      await desk.press('Control+z');
      expect(gap((await merged(desk)).positions, first.positions)).toBe(0);
    });

    await test.step('another visitor gets the same model from the link', async () => {
      const link = await desk.copiedLink();
      await page.keyboard.press('Escape');
      const visitor = await visitorAt(browser, link);
      const seen = await merged(visitor);
      expect(gap(seen.positions, first.positions)).toBe(0);
      await visitor.page.context().close();
    });

    await test.step('every stroke is undone', async () => {
      while ((await desk.history()).index > 0) await desk.press('Control+z');
      await expect(page.getByRole('navigation').getByRole('button', { name: 'Deform' })).toHaveAttribute(
        'aria-pressed',
        'true',
      );
    });
  });
});

test.describe('a lid on a bowl', () => {
  test.use({ viewport: SIZE });

  test('openings are joined by a click on each; pins are added, dragged and removed; the result is exported', async ({
    fresh: desk,
  }) => {
    const { page } = desk;
    const lid = writeModel({ name: 'lid', ...tube(12, 20, dome) }, 'obj');
    await desk.choose(['bowl.obj', writeModel({ name: 'bowl', ...tube(12, 31, bowl, false) }, 'obj')]);
    await page.getByRole('navigation').getByRole('button', { name: 'Merge', exact: true }).click();
    await expect(page.getByRole('heading', { name: 'Choose the part to add' })).toBeVisible();
    await desk.choose(['lid.obj', lid]);
    await page.waitForFunction(
      () => (window.__lissom.app.wings.get('merge') as MergeWing).state.sides.peek().source !== null,
    );
    await desk.settled();

    await test.step('a click on the opening of each joins them', async () => {
      await desk.press('v');
      for (const [side, vertex] of [
        ['source', 4],
        ['target', 6],
      ] as const) {
        const { x, y } = await spotOf(page, side, vertex);
        await page.mouse.move(x, y);
        await page.mouse.click(x, y);
      }
      await desk.settled();
    });
    const joined = await merged(desk);
    expect(joined.problem).toBeNull();
    expect(joined.figures).toMatchObject({ closed: true, eulerCharacteristic: 2 });
    expect(joined.step.boundaries[0]!.keys).toEqual([]);
    expect(joined.pins.length).toBeGreaterThan(0);

    await test.step('a click on the loop sets a pin, a drag moves it, and the merge follows', async () => {
      const free = Array.from({ length: 20 }, (_, i) => i).filter((v) =>
        joined.pins.every(([s]) => Math.abs(s - v) > 2 && Math.abs(s - v) < 18),
      );
      const sight = await Promise.all(free.map(async (v) => ({ v, ...(await spotOf(page, 'source', v)) })));
      // The nearest part of the rim is in sight: it is the lowest on the screen.
      const at = sight.reduce((low, each) => (each.y > low.y ? each : low));
      await page.mouse.click(at.x, at.y);
      const added = await merged(desk);
      expect(added.pins).toHaveLength(joined.pins.length + 1);
      expect(added.step.boundaries[0]!.keys).toHaveLength(added.pins.length);
      const next = await spotOf(page, 'source', (at.v + 1) % 20);
      await desk.drag(at, { x: next.x - at.x, y: next.y - at.y });
      const moved = await merged(desk);
      expect(moved.pins.map(([s]) => s)).toContain((at.v + 1) % 20);
      expect(moved.figures).toMatchObject({ closed: true });
      expect(gap(moved.positions, added.positions)).not.toBe(0);
      await desk.picture('merge-pins');
      await desk.press('Delete');
      expect((await merged(desk)).pins).toHaveLength(joined.pins.length);
    });

    await test.step('what is merged leaves as a file, and is deformed further', async () => {
      await desk.press('Control+e');
      await page.getByRole('radio', { name: /^PLY/ }).check();
      const download = page.waitForEvent('download');
      await page.getByRole('dialog').getByRole('button', { name: 'Export' }).click();
      const { model } = readModel(await bytesOf(await download), 'merged.ply');
      const now = await merged(desk);
      expect(gap(model.positions, now.positions)).toBeLessThan(1e-6 * diagonal(now.positions));
      await page.getByRole('button', { name: 'Deform the result' }).click();
      await desk.settled();
      expect((await desk.shown()).rest.length).toBe(now.positions.length);
      expect((await desk.shown()).step.model).toBe('merge 1');
    });
  });

  test('a mark that cannot be merged is told of in words, in the picture and beside it', async ({
    fresh: desk,
  }) => {
    const { page } = desk;
    await choosePart(desk, 'Octopus');
    await page.locator('.merge-go').getByRole('button', { name: 'Merge' }).click();
    await expect(page.locator('.toast.bad')).toContainText('Paint roughly on both models');
    await desk.press('c');
    const [head] = await spots(page, 'source', [[0, 0.9, 0.2]]);
    await desk.drag(head!, { x: 12, y: 0 });
    await desk.press('b');
    await desk.drag(head!, { x: 12, y: 0 });
    expect((await merged(desk)).figures).toBeNull();
    await page.locator('.merge-go').getByRole('button', { name: 'Merge' }).click();
    await expect(page.locator('.toast.bad').last()).toContainText('on the right');
  });
});
