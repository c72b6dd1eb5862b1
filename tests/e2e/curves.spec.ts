import type { CurvesWing } from '../../web/app/curves/wing';
import type { CurvesStep } from '../../web/recipe/recipe';
import type { Vec3 } from '../../web/view/types';
import { type Desk, expect, gap, test } from './desk';
import { type as typed } from './hair-desk';
import { limbsObj } from './shapes';

test.slow();

const LIMBS = limbsObj();

async function curves(desk: Desk) {
  await desk.settled();
  const read = await desk.page.evaluate(() => {
    const { app } = window.__lissom;
    const { state } = app.wings.get('curves') as CurvesWing;
    const { shown, positions } = app.evaluator.result.peek()!;
    return {
      step: JSON.stringify(state.step.peek()!),
      rest: [...shown.model.positions],
      positions: [...positions],
      grip: state.grip.peek(),
    };
  });
  return {
    ...read,
    step: JSON.parse(read.step) as CurvesStep,
    rest: Float64Array.from(read.rest),
    positions: Float64Array.from(read.positions),
  };
}

/** One stroke over places of the model. */
async function draw(desk: Desk, ...through: readonly Vec3[]): Promise<void> {
  const { mouse } = desk.page;
  const count = (await curves(desk)).step.curves.length;
  const [first, ...others] = await desk.project(...through);
  await mouse.move(first!.x, first!.y);
  await mouse.down();
  for (const { x, y } of others) await mouse.move(x, y, { steps: 8 });
  await desk.picture(`curves-stroke-${count}`);
  await mouse.up();
  await expect.poll(async () => (await curves(desk)).step.curves.length).toBe(count + 1);
}

test('three strokes make a linked skeleton that is bent, twisted and undone', async ({ fresh: desk }) => {
  const { page } = desk;
  await desk.choose(['limbs.obj', LIMBS]);
  await page.getByRole('navigation').getByRole('button', { name: 'Curves', exact: true }).click();
  await expect(page.getByText('Draw a stroke along a limb', { exact: false }).first()).toBeVisible();
  await desk.settled();
  await desk.picture('curves-start');

  await test.step('a stroke along each limb; the arms hang on the trunk', async () => {
    await draw(desk, [1.5, 1, 3], [1.5, 9, 3], [1.5, 17.5, 3]);
    const { step } = await curves(desk);
    const neck = step.curves[0]!.rest.at(-1)!;
    await draw(desk, neck, [8, 17.5, 3], [14, 17.5, 3]);
    await draw(desk, neck, [-6, 17.5, 3], [-11, 17.5, 3]);
    const drawn = await curves(desk);
    await desk.picture('curves-drawn');
    expect(drawn.step.links).toMatchObject([{ parent: 'curve 1' }, { parent: 'curve 1' }]);
    expect(gap(drawn.positions, drawn.rest)).toBeLessThan(1e-9);
  });

  await test.step('a control point is dragged, and the arm follows', async () => {
    await page.keyboard.press('v');
    const before = await curves(desk);
    const hand = before.step.curves[1]!.rest.at(-1)!;
    const [from] = await desk.project(hand);
    await desk.hold(from!, { x: -10, y: 90 });
    await desk.picture('curves-dragging');
    await page.mouse.up();
    await expect.poll(async () => (await curves(desk)).step.curves[1]!.posed !== undefined).toBe(true);
    const { positions, rest, step } = await curves(desk);
    expect(gap(positions, rest)).toBeGreaterThan(1);
    expect(positions.every(Number.isFinite)).toBe(true);
    expect([step.curves[0]!.posed, step.curves[2]!.posed]).toEqual([undefined, undefined]);
    await desk.picture('curves-dragged');
  });

  await test.step('its end is twisted by a number, and undone', async () => {
    const { step } = await curves(desk);
    const hand = step.curves[1]!.posed!.at(-1)!;
    const [at] = await desk.project(hand);
    await page.mouse.click(at!.x, at!.y);
    await desk.settled();
    expect((await curves(desk)).grip).toEqual({ curve: 1, point: hand && step.curves[1]!.rest.length - 1 });
    const before = await curves(desk);
    await typed(desk, 'Twist, degrees', 60);
    await desk.picture('curves-twisted');
    const twisted = await curves(desk);
    expect(twisted.step.curves[1]!.twist!.at(-1)).toBe(60);
    expect(gap(twisted.positions, before.positions)).toBeGreaterThan(0.3);
    await page.keyboard.press('Control+z');
    const undone = await curves(desk);
    expect(undone.step.curves[1]!.twist).toBeUndefined();
    expect(gap(undone.positions, before.positions)).toBe(0);
  });

  await test.step('two poses are kept', async () => {
    await desk.command('Keep this pose');
    await desk.command('All back to rest');
    await desk.command('Keep this pose');
    const { step, positions, rest } = await curves(desk);
    expect(step.poses.map(({ name }) => name)).toEqual(['Pose 1', 'Pose 2']);
    expect(gap(positions, rest)).toBeLessThan(1e-9);
    await page.getByRole('button', { name: 'Pose 1', exact: true }).click();
    expect((await curves(desk)).step.curves[1]!.posed).toEqual(step.poses[0]!.curves[0]!.posed);
    await desk.picture('curves-poses');
  });
});
