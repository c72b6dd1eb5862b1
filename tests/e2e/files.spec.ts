import { readFileSync, writeFileSync } from 'node:fs';
import { readModel } from '../../web/io/index';
import { bytesOf, type Desk, diagonal, expect, gap, moved, test } from './desk';
import { BAR, barObj } from './shapes';

for (const format of ['OBJ', 'PLY', 'STL', 'GLB'] as const) {
  test(`an export as ${format} holds the shape that is shown`, async ({ desk }) => {
    const { page } = desk;
    await desk.drag(await desk.grip(1), { x: -30, y: -70 });
    const shown = await desk.shown();
    expect(moved(shown).length).toBeGreaterThan(0);
    await desk.press('Control+e');
    await page.getByRole('radio', { name: format }).check();
    const download = page.waitForEvent('download');
    await page.getByRole('dialog').getByRole('button', { name: 'Export' }).click();
    const file = await download;
    expect(file.suggestedFilename()).toBe(`bar.${format.toLowerCase()}`);
    const { model } = readModel(await bytesOf(file), file.suggestedFilename());
    const eps = (format === 'PLY' ? 1e-12 : 1e-6) * diagonal(shown.rest);
    if (format === 'STL') {
      // The format knows triangles only: every corner is one of ours.
      const ours = Array.from({ length: shown.positions.length / 3 }, (_, v) =>
        shown.positions.slice(3 * v, 3 * v + 3),
      );
      for (let i = 0; i < model.positions.length; i += 3) {
        const corner = model.positions.slice(i, i + 3);
        expect(ours.some((own) => Math.hypot(...own.map((x, k) => x - corner[k]!)) < eps)).toBe(true);
      }
      return;
    }
    const worst = model.positions.reduce((far, x, i) => Math.max(far, Math.abs(x - shown.positions[i]!)), 0);
    expect(model.positions).toHaveLength(shown.positions.length);
    expect(worst).toBeLessThan(eps);
    if (format === 'GLB') return;
    const before = readModel(Buffer.from(BAR), 'bar.obj').model;
    expect(model.faceVertices).toEqual(before.faceVertices);
    expect(model.faceOffsets).toEqual(before.faceOffsets);
    await expect(page.getByText('0 reordered').last()).toBeVisible();
  });
}

test('a model dropped on the window opens with its quads, and its import report tells what was found', async ({
  desk,
}, info) => {
  const { page } = desk;
  const path = info.outputPath('with-a-hole.obj');
  // The last face is missing, and one vertex is used by none.
  const text = `${barObj(8, 3).trimEnd().split('\n').slice(0, -1).join('\n')}\nv 1 2 30\n`;
  writeFileSync(path, text);
  await drop(desk, path);
  expect(await desk.title()).toBe('with-a-hole');
  const shown = await desk.shown();
  expect(shown.rest).toEqual(readModel(Buffer.from(text), 'with-a-hole.obj').model.positions);
  await expect(page.getByText(/open surface/)).toBeVisible();
  await page.getByRole('button', { name: /Import report/ }).click();
  await expect(page.getByRole('dialog').getByText(/belong to no face|belongs to no face/)).toBeVisible();
  await desk.picture('import-report');
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toHaveCount(0);
});

test('wrong, empty and truncated files are told of in a sentence and cost nothing', async ({ desk }) => {
  await desk.drag(await desk.grip(1), { x: -20, y: -60 });
  const before = await desk.shown();
  const glb = readFileSync('public/gallery/bar.ply').subarray(0, 4000);
  const bad = [
    ['empty.obj', ''],
    ['cut.ply', glb],
    ['letter.obj', 'Dear reader,\nthis is no model.\n'],
    ['recipe.json', '{"lissom":1,"models":{},"steps":[],"outputs":[],"more":1}'],
    ['project.zip', 'PK not really'],
    ['points-on-a-line.obj', 'v 0 0 0\nv 1 0 0\nv 2 0 0\n'],
  ] as const;
  for (const [name, content] of bad) {
    await desk.choose([name, content]);
    const said = await desk.toast();
    expect(said, name).toMatch(/^.{20,}[.!]$/s);
    expect(said, name).not.toMatch(/undefined|null|NaN|Error:|\[object/);
    const after = await desk.shown();
    expect(gap(after.positions, before.positions), name).toBe(0);
    expect(after.step, name).toEqual(before.step);
  }
  await desk.picture('bad-files');
});

test('a project file holds model, recipe and all, and a reload brings the work back', async ({ desk }) => {
  const { page } = desk;
  await desk.drag(await desk.grip(1), { x: -30, y: -70 });
  const before = await desk.shown();
  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  const file = await download;
  expect(file.suggestedFilename()).toBe('bar.zip');
  const project = await bytesOf(file);

  await desk.choose(['other.obj', barObj(6, 2)]);
  expect((await desk.shown()).positions).not.toHaveLength(before.positions.length);
  await desk.choose(['mine.zip', project]);
  const opened = await desk.shown();
  expect(gap(opened.positions, before.positions)).toBe(0);
  expect(opened.step).toEqual(before.step);

  await desk.drag(await desk.grip(1), { x: 20, y: 10 });
  const last = await desk.shown();
  const { entries, index } = await desk.history();
  await expect(page.getByText(/^saved/)).toBeVisible();
  const told = page.getByText('Your work of last time is back.').waitFor();
  await page.reload();
  await desk.ready();
  const back = await desk.shown();
  expect(gap(back.positions, last.positions)).toBe(0);
  expect(back.step).toEqual(last.step);
  expect(await desk.history()).toEqual({ entries, index });
  await told;
  await desk.press('Control+z');
  expect((await desk.shown()).positions).toEqual(opened.positions);

  await test.step('and earlier work is among the restore points', async () => {
    await page.getByRole('button', { name: 'Menu' }).click();
    await page.getByRole('menuitem', { name: 'Restore points' }).click();
    const dialog = page.getByRole('dialog');
    await dialog
      .getByRole('listitem')
      .filter({ hasText: 'other' })
      .getByRole('button', { name: 'Open' })
      .click();
    await expect.poll(() => desk.title()).toBe('other');
  });
});

/** A file dragged in from outside the browser. */
async function drop(desk: Desk, path: string): Promise<void> {
  const session = await desk.page.context().newCDPSession(desk.page);
  const data = { items: [], files: [path], dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const)
    await session.send('Input.dispatchDragEvent', { type, x: 300, y: 300, data });
  await session.detach();
  await desk.read();
}
