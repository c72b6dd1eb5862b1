import { toIndices } from '../../web/core/vertex-set';
import { expect, handleGap, moved, test } from './desk';
import { ofBar } from './shapes';

/** On the side of the bar that faces the viewer. */
const front = (x: number) => ofBar((vx, vy, vz) => vx === x && vy === 2 && vz === 4)[0]!;
const COUNT = ofBar(() => true).length;

test('strokes add to the region, Alt takes away, Shift and a click fill to the border', async ({ desk }) => {
  const { page } = desk;
  const region = async () => new Set(toIndices((await desk.shown()).step.roi, COUNT));
  await page.getByRole('button', { name: 'Clear the region' }).click();
  expect(await region()).toEqual(new Set());
  const before = await desk.history();

  await desk.press('b');
  await desk.stroke([front(5), front(7), front(9)]);
  const painted = await region();
  for (const x of [5, 6, 7, 8, 9]) expect(painted).toContain(front(x));
  expect(painted).not.toContain(front(1));
  // The brush lies on the surface: nothing on the far side.
  for (const v of ofBar((_x, _y, z) => z === 0)) expect(painted).not.toContain(v);
  expect((await desk.history()).entries).toBe(before.entries + 1);
  await desk.picture('paint-region');

  await page.keyboard.down('Alt');
  await desk.stroke([front(7), front(7)]);
  await page.keyboard.up('Alt');
  const erased = await region();
  expect(erased).not.toContain(front(7));
  expect(erased).toContain(front(5));
  for (const v of erased) expect(painted).toContain(v);

  await page.keyboard.down('Shift');
  const hole = await desk.spot(front(7));
  await page.mouse.click(hole.x, hole.y);
  await page.keyboard.up('Shift');
  expect((await region()).size).toBe(COUNT);

  await page.keyboard.press('Control+z');
  await desk.settled();
  expect(await region()).toEqual(erased);
  await desk.press('Escape');
});

test('a stroke makes a handle, a click makes a point handle, and both carry the surface', async ({
  desk,
}) => {
  const { page } = desk;
  await desk.press('n');
  await desk.stroke([front(8), front(9)]);
  const { step } = await desk.shown();
  expect(step.handles).toHaveLength(3);
  expect(toIndices(step.handles[2]!.vertices, COUNT)).toContain(front(8));
  await desk.picture('paint-handle');

  await desk.press('p');
  const on = await desk.spot(front(11));
  await page.mouse.click(on.x, on.y);
  const placed = (await desk.shown()).step.handles[3]!;
  expect(placed).toMatchObject({ kind: 'point', vertices: [front(11)] });
  await desk.press('v');

  const grip = await desk.spot(front(11));
  await desk.drag(grip, { x: 0, y: -50 });
  const pulled = await desk.shown();
  const point = pulled.step.handles[3]!;
  expect(handleGap(point, pulled)).toBeLessThan(1e-6);
  expect(moved(pulled)).toContain(front(11));
  for (const handle of pulled.step.handles) expect(handleGap(handle, pulled)).toBeLessThan(1e-6);
  await desk.picture('point-handle');

  await desk.press('Delete');
  expect((await desk.shown()).step.handles).toHaveLength(3);
});

test('a handle is renamed, hidden and put back to rest from its row', async ({ desk }) => {
  const { page } = desk;
  await desk.drag(await desk.grip(1), { x: 0, y: -60 });
  expect(moved(await desk.shown()).length).toBeGreaterThan(0);
  await page.getByRole('button', { name: 'Rename Tip' }).click();
  await page.getByRole('textbox', { name: 'Rename Tip' }).fill('Nose');
  await page.keyboard.press('Enter');
  expect((await desk.shown()).step.handles[1]!.name).toBe('Nose');
  await page.getByRole('button', { name: 'Hide Nose' }).click();
  expect((await desk.shown()).step.handles[1]!.hidden).toBe(true);
  await page.getByRole('button', { name: 'Handle back to rest' }).click();
  expect(moved(await desk.shown())).toEqual([]);
});
