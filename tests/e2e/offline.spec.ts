// The service worker, in pages of a browser profile of their own and on a server that can go away.

import type { Page } from '@playwright/test';
import { test as base, Desk, expect } from './desk';
import { Site } from './site';

const test = base.extend<{ site: Site }>({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the names of fixtures from the pattern
  site: async ({}, use) => {
    const site = await new Site().start();
    await use(site);
    await site.end();
  },
});

/** Opens the app and waits until all that it needs without a connection is there. */
async function visit(page: Page, address: string): Promise<Desk> {
  const desk = new Desk(page);
  await desk.open(`${address}?test=1`);
  await page.evaluate(async () => {
    const { active } = await navigator.serviceWorker.ready;
    if (active?.state === 'activated') return;
    await new Promise<void>((done) =>
      active?.addEventListener('statechange', () => active.state === 'activated' && done()),
    );
  });
  return desk;
}

const release = (page: Page) => page.evaluate(() => document.head.dataset.release);

const caches = (page: Page) => page.evaluate(() => window.caches.keys());

/** Opens every workspace's part of the program. */
const loadAll = (page: Page) => page.evaluate(() => window.__lissom.app.wings.loadAll());

/** Asks for a newer service worker, as the browser does by itself at every visit, and waits for what comes of it. */
const update = (page: Page) =>
  page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    const found = (await registration.update()) as unknown as ServiceWorkerRegistration;
    const worker = found.installing ?? found.waiting ?? found.active!;
    const isSettled = () => ['activated', 'redundant'].includes(worker.state);
    while (!isSettled()) await new Promise((done) => setTimeout(done, 20));
    return worker.state;
  });

test('after one visit every file of the build is there without a connection, and the app works', async ({
  page,
  site,
}) => {
  await visit(page, site.address);
  await site.stop();
  const desk = new Desk(page);
  await desk.open(`${site.address}?test=1`);
  const before = await desk.shown();
  expect(before.step.handles.length).toBeGreaterThan(0);
  await desk.drag(await desk.grip(0), { x: 30, y: 10 });
  const after = await desk.shown();
  expect(after.positions).not.toEqual(before.positions);
  const files = site.files.map((file) => (file === 'index.html' ? './' : file));
  expect(files.filter((file) => file.startsWith('assets/')).length).toBeGreaterThan(3);
  const answers = await page.evaluate(
    (wanted) => Promise.all(wanted.map(async (file) => [file, (await fetch(file)).status])),
    files,
  );
  expect(answers).toEqual(files.map((file) => [file, 200]));
});

test('a gallery file opened in a tab stays that file, and the start page the start page', async ({
  page,
  site,
}) => {
  await visit(page, site.address);
  await page.goto(`${site.address}gallery/index.json`);
  const json = await page.evaluate(() => document.body.innerText);
  await page.goto(`${site.address}gallery/recipes/octopus-curled.json`);
  await site.stop();
  await new Desk(page).open(`${site.address}?test=1`);
  expect(await page.title()).toContain('Lissom');
  await page.goto(`${site.address}gallery/index.json`);
  expect(await page.evaluate(() => document.body.innerText)).toBe(json);
  await page.goto(`${site.address}gallery/recipes/octopus-curled.json`);
  expect(await page.evaluate(() => document.body.innerText)).toContain('"lissom"');
  await expect(page.goto(`${site.address}gallery/recipes/bar-twisted.json`)).rejects.toThrow(/ERR_/);
});

test('a new version is seen at the next visit, and is the one that starts without a connection', async ({
  page,
  context,
  site,
}) => {
  await visit(page, site.address);
  const old = await context.newPage();
  await visit(old, site.address);
  await page.evaluate(() => window.caches.open('of another site here'));
  const first = await caches(page);

  site.release('second');
  await visit(page, site.address);
  expect(await release(page)).toBe('second');
  expect(await update(page)).toBe('activated');
  // The version before stays, and other sites' caches are not ours.
  expect(await caches(page)).toEqual([...first, expect.stringMatching(/^lissom http/)]);
  const script = await old.evaluate(() => document.querySelector<HTMLScriptElement>('script[src]')!.src);
  expect(await old.evaluate(async (url) => (await fetch(url)).status, script)).toBe(200);

  site.release('third');
  expect(await update(page)).toBe('activated');
  await site.stop();
  await new Desk(page).open(`${site.address}?test=1`);
  expect(await release(page)).toBe('third');
  await loadAll(page);
  expect(await caches(page)).toContain('of another site here');
});

test('a tab that stays open with an old version loads the rest of it, until it is closed', async ({
  page,
  context,
  site,
}) => {
  await visit(page, site.address);
  const old = await context.newPage();
  await visit(old, site.address);
  const [first] = await caches(page);
  for (const name of ['second', 'third', 'fourth']) {
    site.release(name);
    await visit(page, site.address);
    expect(await update(page)).toBe('activated');
  }
  expect(await caches(page)).toContain(first);
  // The second had no tab any more when the fourth came, and was not the one before it.
  expect(await caches(page)).toHaveLength(3);
  await site.stop();
  await loadAll(old);
  await old.close();
  await site.start();
  site.release('fifth');
  expect(await update(page)).toBe('activated');
  expect(await caches(page)).not.toContain(first);
  expect(await caches(page)).toHaveLength(2);
});

test('a version that is replaced while it is being fetched leaves the one before in place', async ({
  page,
  site,
}) => {
  await visit(page, site.address);
  const before = await caches(page);
  site.release('second');
  const worker = site.read('sw.js');
  site.release('third');
  site.write('sw.js', worker);
  for (const file of site.files) if (!site.has(file)) site.write(file, 'not gone yet');
  expect(await update(page).catch(() => 'redundant')).toBe('redundant');
  expect(await caches(page)).toEqual(before);
  await site.stop();
  await new Desk(page).open(`${site.address}?test=1`);
  expect(await release(page)).toBeUndefined();
});

test('a version that cannot be fetched whole leaves the one before in place', async ({ page, site }) => {
  await visit(page, site.address);
  const before = await caches(page);
  site.release('broken');
  site.remove('gallery/index.json');
  const state = await update(page).catch(() => 'redundant');
  expect(state).toBe('redundant');
  expect(await caches(page)).toEqual(before);
  await site.stop();
  await new Desk(page).open(`${site.address}?test=1`);
  expect(await release(page)).toBeUndefined();
});

test('a page that was left open learns of a newer version, and one click brings it', async ({
  page,
  site,
}) => {
  await visit(page, site.address);
  site.release('second');
  await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
  await expect.poll(() => page.evaluate(() => window.__lissom.app.state.updateReady.peek())).toBe(true);
  await page.evaluate(() => window.__lissom.app.reload());
  await expect(page.locator('head')).toHaveAttribute('data-release', 'second');
});

test('the help leads to the licences of all that is shipped', async ({ page, site, context }) => {
  const { dependencies } = (await import('../../package.json', { with: { type: 'json' } })).default;
  await visit(page, site.address);
  await page.keyboard.press('?');
  const opened = context.waitForEvent('page');
  await page.getByRole('link', { name: 'Licences' }).click();
  const list = await (await opened).evaluate(() => document.body.innerText);
  for (const name of [...Object.keys(dependencies), 'Eigen', 'Emscripten'])
    expect(list).toContain(`${name} `);
});
