import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { FolderModels } from '../../web/cli/models';
import { loadKernel } from '../../web/kernel/node';
import { encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import type { Recipe } from '../../web/recipe/recipe';
import { Runner } from '../../web/run/evaluate';
import { Desk, expect, forTest, test } from './desk';

// Each on a page of its own.
test.describe.configure({ mode: 'parallel' });
test.use({ viewport: { width: 1000, height: 760 } });

const recipeOf = (name: string): Recipe =>
  parseRecipe(readFileSync(`public/gallery/recipes/${name}.json`, 'utf8'));

async function opened(desk: Desk, recipe: Recipe, site: string): Promise<void> {
  await desk.open(encodeLink(recipe, site).replace('#', '?test=1#'));
}

/** The recipe that is open, and where the model is, byte for byte. */
async function seen(desk: Desk): Promise<{ readonly recipe: Recipe; readonly hash: string }> {
  await desk.settled();
  const read = await desk.page.evaluate(async () => {
    const { document, evaluator } = window.__lissom.app;
    const { positions } = evaluator.result.peek()!;
    const digest = await crypto.subtle.digest('SHA-256', new Float64Array(positions));
    return {
      recipe: JSON.stringify(document.recipe),
      hash: Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join(''),
    };
  });
  return { recipe: JSON.parse(read.recipe), hash: read.hash };
}

/** What the command line makes of a recipe. */
async function posedHere(recipe: Recipe): Promise<string> {
  const runner = new Runner({ kernel: await loadKernel(), models: new FolderModels('.') });
  const { model } = (await runner.run(recipe)).get(recipe.steps.at(-1)!.id)!;
  return createHash('sha256').update(model.positions).digest('hex');
}

for (const name of ['curves-horse', 'curves-brow', 'curves-snake', 'curves-moebius'])
  test(`${name} opens by its link as the command line makes it`, async ({ page, baseURL }) => {
    const recipe = recipeOf(name);
    const desk = new Desk(page);
    await opened(desk, recipe, baseURL!);
    const { recipe: open, hash } = await seen(desk);
    expect(open).toEqual(recipe);
    expect(hash).toBe(await posedHere(recipe));
    await desk.picture(name);
  });

test('the walk opens by its link, is played, and stands as it stood when it is stopped', async ({
  page,
  baseURL,
}) => {
  const recipe = recipeOf('curves-body-walking');
  const desk = new Desk(page);
  await opened(desk, recipe, baseURL!);
  const before = await seen(desk);
  expect(before.recipe).toEqual(recipe);
  expect(before.hash).toBe(await posedHere(recipe));
  const history = await desk.history();

  const pictures = new Set<string>();
  const look = async () => {
    const picture = await page.locator('canvas').first().screenshot();
    return pictures.add(createHash('sha256').update(picture).digest('hex')).size;
  };
  await look();
  expect(await look()).toBe(1);
  await page.getByRole('button', { name: 'Play the poses' }).click();
  await expect.poll(look, { timeout: 60_000 }).toBeGreaterThan(5);
  await desk.picture('curves-body-walking');

  await page.keyboard.press('Escape');
  const after = await seen(desk);
  expect(after).toEqual(before);
  expect(await desk.history()).toEqual(history);
});

test('chosen in the gallery it has the keys at once: the space bar plays it', async ({ page, baseURL }) => {
  const desk = new Desk(page);
  await desk.open(forTest(baseURL!));
  await page.keyboard.press('Control+g');
  await page
    .getByRole('dialog')
    .getByRole('button', { name: /^Body, walking/ })
    .click();
  await expect.poll(() => desk.title()).toBe('Body, walking');
  await seen(desk);
  await page.keyboard.press('Space');
  await expect(page.getByText('Playing the poses', { exact: false })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.getByText('Playing the poses', { exact: false })).toBeHidden();
});
