import type { DeformWing } from '../../web/app/deform/wing';
import { toIndices } from '../../web/core/vertex-set';
import { centroid } from '../../web/tools/geometry';
import { type Desk, diagonal, expect, gap, handleGap, mayMove, moved, type Place, test } from './desk';

test('the first picture is a model with two handles at rest and one short hint', async ({ fresh: desk }) => {
  const { page } = desk;
  expect(await page.evaluate(() => document.createElement('canvas').getContext('webgl2') !== null)).toBe(
    true,
  );
  await expect(page.getByText('Grab a purple handle and drag')).toBeVisible();
  await expect(page.getByRole('list', { name: 'Handles' }).getByRole('listitem')).toHaveCount(2);
  expect(moved(await desk.shown())).toEqual([]);
  expect(await desk.colours()).toBeGreaterThan(60);
  await desk.picture('first');

  await desk.drag(await desk.grip(0), { x: 180, y: -20 });
  const bent = await desk.shown();
  const eps = 1e-6 * diagonal(bent.rest);
  for (const handle of bent.step.handles) expect(handleGap(handle, bent)).toBeLessThan(eps);
  const allowed = mayMove(bent);
  expect(moved(bent).filter((v) => !allowed.has(v))).toEqual([]);
  expect(moved(bent).length).toBeGreaterThan(3000);
  await expect(page.getByText('Grab a purple handle and drag')).toBeHidden();
  await expect(page.getByText('2 of 2')).toBeVisible();
  await desk.picture('bent');
});

test('a dragged handle goes where the pointer goes, its region follows, nothing else moves', async ({
  desk,
}) => {
  const grip = await desk.grip(1);
  await desk.drag(grip, { x: -60, y: -140 });
  const bent = await desk.shown();
  const eps = 1e-6 * diagonal(bent.rest);
  for (const handle of bent.step.handles) expect(handleGap(handle, bent)).toBeLessThan(eps);
  const there = await desk.grip(1);
  expect(Math.hypot(there.x - grip.x + 60, there.y - grip.y + 140)).toBeLessThan(40);
  const allowed = mayMove(bent);
  expect(moved(bent).filter((v) => !allowed.has(v))).toEqual([]);
  const handles = new Set(bent.step.handles.flatMap(({ vertices }) => [...toIndices(vertices, 1e9)]));
  expect(moved(bent).filter((v) => !handles.has(v)).length).toBeGreaterThan(100);
  await desk.picture('bar-bent');

  await test.step('undo and redo bring positions and selection back', async () => {
    expect(bent.selected).toBe(1);
    await desk.press('Control+z');
    const back = await desk.shown();
    expect(moved(back)).toEqual([]);
    expect(back.selected).toBeNull();
    await desk.press('Control+Shift+Z');
    const again = await desk.shown();
    expect(gap(again.positions, bent.positions)).toBe(0);
    expect(again.selected).toBe(1);
  });

  await test.step('Escape while dragging leaves no trace', async () => {
    const before = await desk.history();
    await desk.hold(await desk.grip(1), { x: 90, y: 60 });
    expect(await desk.page.evaluate(() => window.__lissom.app.state.previewing.peek())).toBe(true);
    await desk.page.keyboard.press('Escape');
    await desk.page.mouse.up();
    const after = await desk.shown();
    expect(gap(after.positions, bent.positions)).toBe(0);
    expect(after.step).toEqual(bent.step);
    expect(await desk.history()).toEqual(before);
  });

  await test.step('the heat map has a value for every vertex and a legend', async () => {
    await desk.press('t');
    await expect(desk.page.getByText('Edge stretch')).toBeVisible();
    const stretch = await desk.page.evaluate(() => [
      ...((window.__lissom.app.wings.get('deform') as DeformWing).state.stretch.peek() ?? []),
    ]);
    expect(stretch).toHaveLength(bent.rest.length / 3);
    expect(Math.max(...stretch.map(Math.abs))).toBeGreaterThan(0.01);
    await desk.picture('heat');
    await desk.press('t');
    await expect(desk.page.getByText('Edge stretch')).toBeHidden();
  });
});

test('numbers typed in turn a handle by exactly 90 degrees, and each method answers in its own way', async ({
  desk,
}) => {
  const { page } = desk;
  await page.getByRole('button', { name: /^Tip/ }).click();
  const field = page.getByRole('textbox', { name: 'Turn Z' });
  await field.fill('90');
  await field.press('Enter');
  const turned = await desk.shown();
  const tip = turned.step.handles[1]!;
  if (tip.kind !== 'region') throw new Error('the tip is a region');
  expect([0, 1, 2, 4, 5, 6, 8, 9, 10].map((i) => tip.matrix[i])).toEqual([0, 1, 0, -1, 0, 0, 0, 0, 1]);
  expect(handleGap(tip, turned)).toBeLessThan(1e-6 * diagonal(turned.rest));
  await desk.picture('turned');

  const answers = [turned.positions];
  await page.getByRole('switch', { name: 'Remove shear' }).click();
  answers.push((await desk.shown()).positions);
  await page.getByLabel('Follow by').selectOption('naive');
  answers.push((await desk.shown()).positions);
  await page.getByLabel('Follow by').selectOption('iterative');
  await page.getByRole('textbox', { name: 'Iterations' }).fill('5');
  await page.keyboard.press('Enter');
  answers.push((await desk.shown()).positions);
  for (let i = 0; i < answers.length; i++)
    for (let j = 0; j < i; j++)
      expect(gap(answers[i]!, answers[j]!), `${i} and ${j}`).toBeGreaterThan(1e-3 * diagonal(turned.rest));
});

test('the gizmo moves along one axis, turns about the middle and scales', async ({ desk }) => {
  const { page } = desk;
  await page.getByRole('button', { name: /^Tip/ }).click();
  const { middle, up } = await gizmo(desk);
  const at = (reach: number): Place => ({ x: middle.x + reach * up.x, y: middle.y + reach * up.y });
  await page.mouse.move(at(60).x, at(60).y);
  await desk.drag(at(60), { x: 50 * up.x + 5, y: 50 * up.y });
  const lifted = await desk.shown();
  const matrix = (shown: typeof lifted) => {
    const handle = shown.step.handles[1]!;
    if (handle.kind !== 'region') throw new Error('the tip is a region');
    expect(handleGap(handle, shown)).toBeLessThan(1e-6 * diagonal(shown.rest));
    return handle.matrix;
  };
  expect(matrix(lifted)[13]).toBeGreaterThan(0.5);
  expect(matrix(lifted)[12]).toBeCloseTo(0, 9);
  expect(matrix(lifted)[14]).toBeCloseTo(0, 9);
  await desk.picture('gizmo-move');

  await desk.press('Control+z');
  await desk.press('r');
  await page.mouse.move(at(60).x, at(60).y);
  await desk.drag(at(60), { x: 40 * up.x, y: 40 * up.y });
  const scaled = matrix(await desk.shown());
  expect(scaled[5]).toBeGreaterThan(1.1);
  expect([scaled[0], scaled[10]]).toEqual([1, 1]);
  await desk.press('Control+z');
  expect(moved(await desk.shown())).toEqual([]);
  await desk.press('w');
});

/** Where the gizmo of the selected handle stands on the page, and which way up its upright arrow points. */
async function gizmo(desk: Desk): Promise<{ middle: Place; up: Place }> {
  const { step, rest, selected } = await desk.shown();
  const [x, y, z] = centroid(rest, toIndices(step.handles[selected!]!.vertices, rest.length / 3));
  const [middle, above] = await desk.project([x, y, z], [x, y + 1, z]);
  const [dx, dy] = [above!.x - middle!.x, above!.y - middle!.y];
  const length = Math.hypot(dx, dy);
  return { middle: middle!, up: { x: dx / length, y: dy / length } };
}
