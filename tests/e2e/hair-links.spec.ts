import { readdirSync } from 'node:fs';
import { encodeLink } from '../../web/recipe/link/link';
import { bytesOf, Desk, expect, SIZE, test, visitorAt } from './desk';
import { drawAt, enter, grownHere, hair, styleOf } from './hair-desk';

// Each on a page of its own.
test.describe.configure({ mode: 'parallel' });

test.describe('a style that was drawn', () => {
  test.use({ viewport: SIZE });

  test('travels as a link to the same bytes, and leaves as strands with its head', async ({
    fresh: desk,
    browser,
  }) => {
    const { page } = desk;
    const count = 400;
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await enter(desk, count);
    await drawAt(desk, [0.02, -0.55], [0.22, -0.45], [0.34, -0.15], [0.36, 0.15]);
    const sent = await hair(desk);

    await test.step('a friend opens it without a click', async () => {
      const link = await desk.copiedLink();
      expect(link.length).toBeLessThan(2000);
      const visitor = await visitorAt(browser, link);
      const seen = await hair(visitor);
      expect(seen.hash).toBe(sent.hash);
      expect(seen.step).toEqual(sent.step);
      await visitor.page.context().close();
      await page.keyboard.press('Escape');
    });

    const exported = async (format: RegExp): Promise<Buffer> => {
      await desk.press('Control+e');
      await page.getByRole('radio', { name: format }).check();
      const download = page.waitForEvent('download');
      await page.getByRole('dialog').getByRole('button', { name: 'Export' }).click();
      return Buffer.from(await bytesOf(await download));
    };
    await test.step('as .hair', async () => {
      const bytes = await exported(/HAIR/);
      expect(bytes.toString('latin1', 0, 4)).toBe('HAIR');
      expect(bytes.readUInt32LE(4)).toBeGreaterThan(count / 2);
      expect(bytes.readUInt32LE(4)).toBeLessThanOrEqual(count);
    });
    await test.step('as USD, with the head', async () => {
      const text = (await exported(/USD/)).toString('latin1');
      expect(text).toMatch(/^#usda 1\.0/);
      expect(text).toContain('def BasisCurves');
      expect(text).toContain('def Mesh');
    });
  });

  test('is refused kindly when the link was damaged on its way', async ({ page, baseURL }) => {
    const desk = new Desk(page);
    const link = encodeLink(styleOf('hair-bob.json', 500), baseURL!);
    await desk.open(`${link.slice(0, -40)}`.replace('#', '?test=1#'));
    expect(await desk.toast()).toContain('link');
    expect(await page.evaluate(() => window.__lissom.app.evaluator.result.peek() !== null)).toBe(true);
  });
});

test.describe('the gallery of styles', () => {
  test.use({ viewport: { width: 1000, height: 760 } });
  const count = 6000;

  for (const file of readdirSync('public/gallery/recipes').filter((each) => /^hair-.*\.json$/.test(each))) {
    const name = file.replace('.json', '');
    test(`${name} opens by its link as the command line grows it`, async ({ page, baseURL }) => {
      const recipe = styleOf(file, count);
      const desk = new Desk(page);
      await desk.open(encodeLink(recipe, baseURL!).replace('#', '?test=1#'));
      const seen = await hair(desk);
      expect(seen.recipe).toEqual(recipe);
      expect(seen.strands).toBe(count);
      expect(seen.hash).toBe(await grownHere(recipe));
      await desk.picture(name);
    });
  }
});
