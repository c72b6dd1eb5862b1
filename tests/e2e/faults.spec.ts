// What a crash may cost a person: nothing. The short run has the same seeds every time; the long one is
// `npm run faults`, which sets how many there are and where they begin.

import { chromium, expect, test } from '@playwright/test';
import { Random } from '../fuzz/random';
import { type Death, end, faults } from './faults/faults';
import { type Outcome, profileWithBar, trial } from './faults/trial';
import { type BlindDesk, saved, Victim, workIn } from './faults/victim';
import { BAR, BAR_RECIPE } from './shapes';
import { Site } from './site';

const isLong = process.env.LISSOM_FAULTS !== undefined;
const count = Number(process.env.LISSOM_FAULTS ?? 10);
const from = Number(process.env.LISSOM_FAULTS_FROM ?? 0);

const storyOf = ({ seed, kind, story }: Outcome) => `seed ${seed}, ${kind}: ${story.join(', ')}`;

test(`${count} faults at random moments of random edits cost no edit`, async ({ browser, baseURL }) => {
  test.setTimeout(60_000 + 60_000 * count);
  const profile = await profileWithBar(browser, baseURL!);
  const outcomes: Outcome[] = [];
  for (let seed = from; seed < from + count; seed++) {
    const outcome = await trial(browser, { baseURL: baseURL!, profile }, seed);
    outcomes.push(outcome);
    if (isLong) console.log([storyOf(outcome), ...outcome.lost].join('\n  '));
  }
  for (const kind of new Set(outcomes.map((outcome) => outcome.kind))) {
    const all = outcomes.filter((outcome) => outcome.kind === kind);
    const edits = all.reduce((sum, outcome) => sum + outcome.edits, 0);
    const lost = all.filter((outcome) => outcome.lost.length > 0);
    const seeds = lost.length > 0 ? `: seeds ${lost.map(({ seed }) => seed).join(', ')}` : '';
    console.log(`${kind.padEnd(24)} ${all.length} faults, ${edits} edits, ${lost.length} lost${seeds}`);
  }
  const lost = outcomes.filter((outcome) => outcome.lost.length > 0);
  expect(lost.map((outcome) => [storyOf(outcome), ...outcome.lost].join('\n'))).toEqual([]);
});

/** Types a number for the tip of the bar. */
async function lift({ page }: BlindDesk, by: number): Promise<void> {
  const row = page.getByRole('list', { name: 'Handles' }).locator('.row-main', { hasText: 'Tip' });
  if ((await row.getAttribute('aria-pressed')) !== 'true') await row.click();
  await page.getByRole('textbox', { name: 'Move Y' }).fill(String(by));
  await page.keyboard.press('Enter');
}

for (const death of ['close', 'crash', 'reload'] satisfies Death[])
  test(`an edit made 50 ms before the tab ends (${death}) is there again`, async ({ browser, baseURL }) => {
    const victim = await Victim.arrive(browser, { baseURL: baseURL! });
    const desk = await victim.open();
    await desk.choose(['bar.json', BAR_RECIPE], ['bar.obj', BAR]);
    await lift(desk, 1);
    await saved(desk);
    const { load } = await workIn(desk);
    const before = victim.commits(load).length;
    await lift(desk, 3);
    while (victim.commits(load).length === before) await new Promise((done) => setTimeout(done, 1));
    await new Promise((done) => setTimeout(done, 50));
    await end(desk.page, death);
    const again = death === 'reload' ? desk : await victim.open();
    await again.ready();
    const { recipe, positions } = await workIn(again);
    expect(recipe).toBe(victim.commits(load).at(-1));
    expect(JSON.parse(recipe)).toMatchObject({
      steps: [{ handles: [{}, { matrix: expect.arrayContaining([3]) }] }],
    });
    expect(positions).not.toBeNull();
    expect(victim.troubles).toEqual([]);
    await victim.leave();
  });

test('a page whose last edit is kept nowhere asks before it is left', async ({ browser, baseURL }) => {
  const victim = await Victim.arrive(browser, { baseURL: baseURL! });
  const desk = await victim.open();
  const { page } = desk;
  await desk.choose(['bar.json', BAR_RECIPE], ['bar.obj', BAR]);
  await saved(desk);
  const asked: string[] = [];
  page.on('dialog', (dialog) => {
    asked.push(dialog.type());
    void dialog.dismiss();
  });
  const heals = [];
  for (const kind of ['journal full', 'database refuses'])
    heals.push(await faults.find((each) => each.kind === kind)!.begin!(victim, desk, new Random(1)));
  await lift(desk, 3);
  await page.waitForFunction(() => window.__lissom.app.state.saved.peek().kind === 'failed');
  const before = await workIn(desk);
  await page.evaluate(() => location.reload());
  await expect.poll(() => asked).toEqual(['beforeunload']);
  for (const heal of heals) await heal();
  await saved(desk);
  await page.reload();
  await desk.ready();
  expect(asked).toHaveLength(1);
  expect((await workIn(desk)).recipe).toBe(before.recipe);
  await victim.leave();
});

test('on plain http, where the browser has no locks, two tabs do not share a document', async () => {
  const site = await new Site().start();
  const { launchOptions = {} } = test.info().project.use;
  const browser = await chromium.launch({
    ...launchOptions,
    // Any other name than localhost is an insecure place.
    args: [...(launchOptions.args ?? []), '--host-resolver-rules=MAP lissom.test 127.0.0.1'],
  });
  const victim = await Victim.arrive(browser, { baseURL: `http://lissom.test:${site.port}/` });
  const one = await victim.open();
  expect(await one.page.evaluate(() => [isSecureContext, 'locks' in navigator])).toEqual([false, false]);
  await one.choose(['bar.json', BAR_RECIPE], ['bar.obj', BAR]);
  await lift(one, 1);
  await saved(one);
  const shared = (await workIn(one)).recipe;

  const two = await victim.duplicate(one);
  // A tab that is too busy to say in time that the work is its own is copied, and else left alone.
  if ((await workIn(two)).recipe !== shared) await two.openEarlier('bar');
  expect((await workIn(two)).recipe).toBe(shared);
  await lift(two, 2);
  await lift(one, 4);
  const works = [await workIn(one), await workIn(two)];
  expect(works[0]!.recipe).not.toBe(works[1]!.recipe);

  for (const [i, desk] of [one, two].entries()) {
    await desk.page.reload();
    await desk.ready();
    expect((await workIn(desk)).recipe).toBe(works[i]!.recipe);
  }
  for (const desk of [one, two]) await end(desk.page, 'close');
  const again = await workIn(await victim.open());
  expect(works.map(({ recipe }) => recipe)).toContain(again.recipe);
  expect(victim.troubles).toEqual([]);
  await browser.close();
  await site.end();
});
