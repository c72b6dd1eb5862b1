import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import { Desk, expect, moved, SIZE, test } from './desk';

test.use({ viewport: SIZE });

test('at 1024 × 700 nothing is cut, covered or scrolled sideways', async ({ desk }) => {
  const { page } = desk;
  await page.setViewportSize({ width: 1024, height: 700 });
  await page.getByRole('button', { name: /^Tip/ }).click();
  await desk.settled();
  const wrong = await page.evaluate(() => {
    const found: string[] = [];
    const { innerWidth, innerHeight } = window;
    if (document.documentElement.scrollWidth > innerWidth) found.push('the page scrolls sideways');
    const panel = document.querySelector('.side-panel')!;
    if (panel.scrollWidth > panel.clientWidth) found.push('the panel scrolls sideways');
    for (const button of document.querySelectorAll(
      '.top-bar button, .tool-rail button, .view-bar > button',
    )) {
      const box = button.getBoundingClientRect();
      if (box.width === 0) continue;
      const name = button.getAttribute('aria-label') ?? button.textContent;
      if (box.left < 0 || box.top < 0 || box.right > innerWidth || box.bottom > innerHeight)
        found.push(`${name} is cut`);
      const top = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
      if (!top || !button.contains(top)) found.push(`${name} is covered`);
    }
    for (const text of document.querySelectorAll<HTMLElement>(
      '.side-panel button, .side-panel input, .side-panel .label',
    )) {
      if (text.scrollWidth > text.clientWidth + 1) found.push(`“${text.textContent}” does not fit`);
    }
    return found;
  });
  expect(wrong).toEqual([]);
  await desk.picture('1024x700');
});

test('the title gives way to the buttons beside it, and whether it is saved is seen, at every width', async ({
  desk,
}) => {
  const { page } = desk;
  await desk.drag(await desk.grip(1), { x: -20, y: -30 });
  await expect(page.getByText(/^saved/)).toBeVisible();
  for (const width of [1440, 1180, 1024, 940, 860, 800]) {
    await page.setViewportSize({ width, height: 700 });
    const wrong = await page.evaluate(() => {
      const title = document.querySelector('.top-middle')!.getBoundingClientRect();
      const found: string[] = [];
      for (const button of document.querySelectorAll('.top-bar button')) {
        const box = button.getBoundingClientRect();
        if (box.width === 0) continue;
        const name = button.getAttribute('aria-label') ?? button.textContent;
        if (box.right > window.innerWidth) found.push(`${name} is cut`);
        if (title.width > 0 && box.right > title.left && box.left < title.right)
          found.push(`the title lies on ${name}`);
      }
      const saved = document.querySelector<HTMLElement>('.saved')!;
      const note = saved.getBoundingClientRect();
      if (window.innerWidth >= 860 && (note.width === 0 || note.right > title.right + 1 || note.bottom > 44))
        found.push(`“${saved.textContent}” does not fit`);
      return found;
    });
    expect(wrong, `${width} pixels wide`).toEqual([]);
    await desk.picture(`top-${width}`);
  }
});

test('on a phone one can look, turn with a finger and open links', async ({ browser, baseURL }) => {
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    baseURL: baseURL!,
  });
  const page = await context.newPage();
  const desk = new Desk(page);
  const recipe = parseRecipe(readFileSync('public/gallery/recipes/octopus-curled.json', 'utf8'));
  await desk.open(encodeLink(recipe, baseURL!).replace('#', '?test=1#'));
  const shown = await desk.shown();
  expect(moved(shown).length).toBeGreaterThan(1000);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await desk.picture('phone');

  const camera = () => page.evaluate(() => window.__lissom.app.viewport!.camera);
  const before = await camera();
  const session = await context.newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...touchPoints: { x: number; y: number }[]) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints });
  await touch('touchStart', { x: 330, y: 700 });
  for (let i = 1; i <= 4; i++) await touch('touchMove', { x: 330 - 30 * i, y: 700 });
  await touch('touchEnd');
  await desk.settled();
  const turned = await camera();
  expect(turned.target).toEqual(before.target);
  expect(Math.hypot(...turned.position.map((x, k) => x - before.position[k]!))).toBeGreaterThan(0.1);
  await touch('touchStart', { x: 150, y: 500 }, { x: 250, y: 500 });
  await touch('touchMove', { x: 110, y: 500 }, { x: 290, y: 500 });
  await touch('touchEnd');
  await desk.settled();
  const away = ({ position, target }: typeof before) => Math.hypot(...position.map((x, k) => x - target[k]!));
  expect(away(await camera())).toBeLessThan(0.8 * away(turned));
  expect((await desk.shown()).step).toEqual(shown.step);
  await desk.picture('phone-turned');
  await context.close();
});

test('it works from a sub-path, and after one visit without any connection', async ({ page, baseURL }) => {
  const server = createServer(async ({ url = '/' }, response) => {
    if (!url.startsWith('/x/')) return response.writeHead(404).end();
    const answer = await fetch(new URL(url.slice(3), baseURL));
    const type = answer.headers.get('content-type') ?? 'application/octet-stream';
    response.writeHead(answer.status, { 'content-type': type });
    return response.end(Buffer.from(await answer.arrayBuffer()));
  });
  await new Promise<void>((done) => server.listen(0, () => done()));
  const { port } = server.address() as AddressInfo;
  const desk = new Desk(page);
  try {
    // As visitors have it: with all its light, smoothing and motion.
    await desk.open(`http://localhost:${port}/x/`);
    expect((await desk.shown()).step.handles).toHaveLength(2);
    await page.evaluate(async () => {
      await navigator.serviceWorker.ready;
      const kept = async () =>
        (await (await caches.open((await caches.keys())[0]!)).keys()).map(({ url }) => url);
      while (!(await kept()).some((url) => url.endsWith('.wasm')))
        await new Promise((next) => setTimeout(next, 100));
    });
  } finally {
    server.closeAllConnections();
    server.close();
  }
  await page.reload();
  await desk.ready();
  await desk.drag(await desk.grip(0), { x: 80, y: 0 });
  expect(moved(await desk.shown()).length).toBeGreaterThan(1000);
});
