// What cost a tab before costs a message: the page answers all the while. How long it was busy at a time is printed.

import { writeFileSync } from 'node:fs';
import { equalRanges, instances, longRecipe, manyEntries, tablesOfNothing } from '../repro/hostile';
import { expect, SIZE, test } from './desk';

test.use({ viewport: SIZE });

const FILES: readonly [what: string, name: string, make: () => Uint8Array, says: RegExp][] = [
  [
    'glTF that shows one mesh ten thousand times',
    'many.gltf',
    () => instances(10_000, 3000),
    /many\.gltf has/,
  ],
  ['999 entries over one block', 'many.zip', manyEntries, /The archive unpacks to more than/],
  ['a recipe of 60 MB in 3', 'long.zip', longRecipe, /in the archive has 60 MB/],
  ['OFF 0 0 0', 'none.off', () => new TextEncoder().encode('OFF 0 0 0\n'), /holds no vertex/],
];

test('hostile links and files are refused while the page answers', async ({ fresh: desk }) => {
  const { page } = desk;
  await page.evaluate(() => {
    const seen = { longest: 0 };
    Object.assign(window, { __tasks: seen });
    new PerformanceObserver((list) => {
      for (const { duration } of list.getEntries()) seen.longest = Math.max(seen.longest, duration);
    }).observe({ type: 'longtask' });
  });
  const busy = () =>
    page.evaluate(async () => {
      await new Promise(requestAnimationFrame);
      const seen = (window as unknown as { __tasks: { longest: number } }).__tasks;
      const { longest } = seen;
      seen.longest = 0;
      return Math.round(longest);
    });
  const before = await desk.shown();
  const unchanged = async () => expect((await desk.shown()).positions).toEqual(before.positions);
  const told = async (what: string, says: RegExp, since: number) => {
    await expect(page.locator('.toast').filter({ hasText: says }).last()).toBeVisible();
    console.log(`${what}: told after ${Date.now() - since} ms, longest task ${await busy()} ms`);
    await unchanged();
  };
  // From the disk: bytes handed over by the test would themselves keep the page busy.
  const choose = async (file: string) => {
    const asked = page.waitForEvent('filechooser');
    await page.keyboard.press('Control+o');
    await (await asked).setFiles(file);
    await desk.read();
  };
  await busy();

  for (const [what, name, make, says] of FILES) {
    const file = test.info().outputPath(name);
    writeFileSync(file, make());
    const since = Date.now();
    await choose(file);
    await told(what, says, since);
  }

  const open = (link: string) =>
    page.evaluate(
      (hash) => {
        location.hash = hash;
      },
      link.slice(link.indexOf('#')),
    );
  const since = Date.now();
  await open(tablesOfNothing());
  await told('a link of tables without columns', /The link is damaged/, since);

  await test.step('a link that names the same vertices twenty thousand times opens as what it says once', async () => {
    const started = Date.now();
    await open(equalRanges());
    await expect
      .poll(() => page.evaluate(() => window.__lissom.app.document.recipe.steps[0]?.id === 'd'))
      .toBe(true);
    await desk.settled();
    console.log(`equal ranges: open after ${Date.now() - started} ms, longest task ${await busy()} ms`);
  });
});
