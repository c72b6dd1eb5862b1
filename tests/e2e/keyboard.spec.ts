import { serious } from './axe';
import { type Desk, expect, handleGap, moved, test } from './desk';

test('everything up to an exported bend can be done without a pointer', async ({ desk }) => {
  const { page } = desk;
  await tabTo(desk, /^Tip/);
  await page.keyboard.press('Enter');
  expect((await desk.shown()).selected).toBe(1);
  await tabTo(desk, 'Move Y');
  await page.keyboard.type('3');
  await page.keyboard.press('Enter');
  const lifted = await desk.shown();
  expect(lifted.step.handles[1]).toMatchObject({ matrix: expect.arrayContaining([3]) });
  expect(handleGap(lifted.step.handles[1]!, lifted)).toBeLessThan(1e-6);
  await page.keyboard.press('ArrowUp');
  const nudged = await desk.shown();
  expect(moved({ rest: lifted.positions, positions: nudged.positions }).length).toBeGreaterThan(0);
  // Out of the text field, which has its own keys.
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+e');
  await expect(page.getByRole('dialog')).toBeVisible();
  const download = page.waitForEvent('download');
  await page.keyboard.press('Enter');
  expect((await download).suggestedFilename()).toBe('bar.obj');
});

test('the palette finds commands by a few letters and runs them; Escape gives the focus back', async ({
  desk,
}) => {
  const { page } = desk;
  await desk.command('everything');
  expect((await desk.shown()).step.roi).toBe('all');
  await desk.command('wirefr');
  expect(await page.evaluate(() => window.__lissom.app.state.display.peek().wireframe)).toBe(true);
  await desk.command('wirefr');
  const share = page.getByRole('button', { name: 'Share…' });
  await share.focus();
  for (const key of ['Control+g', 'Control+e', 'Control+,', '?', 'Control+k']) {
    await page.keyboard.press(key);
    await expect(page.getByRole('dialog'), key).toHaveCount(1);
    await page.keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toHaveCount(0);
    await expect(share, key).toBeFocused();
  }
});

test('a scan for accessibility finds nothing serious on the page or in any dialog', async ({ desk }) => {
  test.slow();
  const { page } = desk;
  await page.getByRole('button', { name: /^Tip/ }).click();
  await desk.press('t');
  expect(await serious(desk), 'page').toEqual([]);
  await desk.press('t');
  await desk.command('light or dark');
  expect(await serious(desk), 'page in light').toEqual([]);
  await desk.picture('light');
  const dialogs = {
    gallery: 'Control+g',
    export: 'Control+e',
    settings: 'Control+,',
    help: '?',
    palette: 'Control+k',
  };
  for (const [name, key] of Object.entries(dialogs)) {
    await page.keyboard.press(key);
    await expect(page.getByRole('dialog')).toBeVisible();
    expect(await serious(desk), `${name} in light`).toEqual([]);
    await page.keyboard.press('Escape');
  }
  await desk.command('light or dark');
  for (const [name, key] of Object.entries(dialogs)) {
    await page.keyboard.press(key);
    await expect(page.getByRole('dialog')).toBeVisible();
    expect(await serious(desk), name).toEqual([]);
    await desk.picture(`dialog-${name}`);
    await page.keyboard.press('Escape');
  }
  for (const name of ['share', 'restore points']) {
    await desk.command(name);
    await expect(page.getByRole('dialog')).toBeVisible();
    expect(await serious(desk), name).toEqual([]);
    await desk.picture(`dialog-${name}`);
    await page.keyboard.press('Escape');
  }
});

/** Presses Tab until what is focused has this name. */
async function tabTo({ page }: Desk, name: string | RegExp): Promise<void> {
  for (let i = 0; i < 80; i++) {
    await page.keyboard.press('Tab');
    const focused = await page.evaluate(() => {
      const element = document.activeElement;
      return element?.getAttribute('aria-label') ?? element?.textContent?.trim() ?? '';
    });
    if (typeof name === 'string' ? focused === name : name.test(focused)) return;
  }
  throw new Error(`Tab never came to ${name}`);
}
