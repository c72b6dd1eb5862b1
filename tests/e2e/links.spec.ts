import { readFileSync } from 'node:fs';
import { encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import { Desk, diagonal, expect, forTest, gap, moved, SIZE, test, visitorAt, withoutPickers } from './desk';
import { BAR, BAR_RECIPE } from './shapes';

test.use({ viewport: SIZE });

test('a copied link shows another visitor the same shape at once and keeps what they had', async ({
  fresh: desk,
  browser,
}) => {
  const { page } = desk;
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await desk.drag(await desk.grip(0), { x: 160, y: -10 });
  const sent = await desk.shown();
  const link = await desk.copiedLink();
  expect(link.length).toBeLessThan(2000);
  await desk.picture('share');

  const visitor = await visitorAt(browser, new URL('./', page.url()).href);
  await visitor.drag(await visitor.grip(1), { x: 40, y: -60 });
  const own = await visitor.shown();
  await expect(visitor.page.getByText(/^saved/)).toBeVisible();
  // The page stays, only its address changes: the link is read aside while the page goes on.
  await visitor.open(forTest(link));
  await expect
    .poll(async () => gap((await visitor.shown()).positions, sent.positions))
    .toBeLessThan(1e-6 * diagonal(sent.rest));
  const seen = await visitor.shown();
  expect(moved(seen).length).toBeGreaterThan(1000);
  await visitor.picture('link-opened');

  await test.step('a link pasted damaged is told of and changes nothing', async () => {
    for (const damaged of [`${link.slice(0, -40)}`, link.replace(/.{5}$/, 'AAAAA')]) {
      await visitor.page.evaluate((hash) => {
        location.hash = hash;
      }, new URL(damaged).hash);
      await expect(visitor.page.locator('.toast.bad, .toast.warn').last()).toContainText(/link/i);
      expect(gap((await visitor.shown()).positions, seen.positions)).toBe(0);
    }
  });

  await test.step('the work from before is one click away', async () => {
    await visitor.command('restore points');
    const rows = visitor.page.getByRole('dialog').getByRole('listitem');
    await rows.getByRole('button', { name: 'Open' }).last().click();
    await expect
      .poll(async () => gap((await visitor.shown()).positions, own.positions))
      .toBeLessThan(1e-6 * diagonal(own.rest));
  });
  await visitor.page.context().close();
});

test('a page opened with a link cut short starts as ever and says so', async ({ page, baseURL }) => {
  const recipe = parseRecipe(readFileSync('public/gallery/recipes/dinosaur-looking-back.json', 'utf8'));
  const desk = new Desk(page);
  await desk.open(forTest(encodeLink(recipe, baseURL!).slice(0, -60)));
  await expect(page.locator('.toast').last()).toContainText(/link/i);
  expect(moved(await desk.shown())).toEqual([]);
  await desk.drag(await desk.grip(0), { x: 60, y: 0 });
  expect(moved(await desk.shown()).length).toBeGreaterThan(1000);
  await desk.picture('link-damaged');
});

test('a reload brings back what is open, not the link that the page was once opened with', async ({
  page,
  baseURL,
}) => {
  const sent = { lissom: 1 as const, models: { key: { builtin: 'key' } }, steps: [], outputs: [] };
  const desk = new Desk(await withoutPickers(page));
  const title = () => page.title();
  await desk.open(forTest(encodeLink(sent, baseURL!)));
  expect(await title()).toContain('key');
  await desk.choose(['bar.json', BAR_RECIPE], ['bar.obj', BAR]);
  await page.reload();
  await desk.ready();
  expect(await title()).toContain('bar');
  await page.evaluate(() => {
    location.hash = '#r=AAAA';
  });
  await expect(page.locator('.toast').last()).toContainText(/link/i);
  await page.reload();
  await desk.ready();
  expect(await title()).toContain('bar');
});
