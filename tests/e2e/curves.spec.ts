import { type Object3D, type SkinnedMesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import type { CurvesWing } from '../../web/app/curves/wing';
import type { CurvesStep } from '../../web/recipe/recipe';
import { tangentAt } from '../../web/tools/curves/spline';
import { anyNormal, cross } from '../../web/tools/geometry';
import type { Vec3 } from '../../web/view/types';
import { bytesOf, type Desk, diagonal, expect, gap, test } from './desk';
import { type as typed } from './hair-desk';
import { limbsObj } from './shapes';

test.slow();

const LIMBS = limbsObj();
/** Radius of the gizmo's rings in CSS pixels. */
const RING = 70;

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

  await test.step('the twist ring is turned with the mouse', async () => {
    const { step, grip } = await curves(desk);
    expect(grip).toEqual({ curve: 1, point: step.curves[1]!.rest.length - 1 });
    await page.keyboard.press('q');
    const ring = await twistRing(desk, 1);
    await page.mouse.move(ring[0]!.x, ring[0]!.y);
    await page.mouse.down();
    for (const { x, y } of ring.slice(1)) await page.mouse.move(x, y, { steps: 3 });
    await desk.picture('curves-twist-ring');
    await page.mouse.up();
    await expect.poll(async () => (await curves(desk)).step.curves[1]!.twist?.at(-1)).toBeDefined();
    const turned = await curves(desk);
    expect(Math.abs(turned.step.curves[1]!.twist!.at(-1)!)).toBeGreaterThan(20);
    // The curve itself stays where it was.
    expect(turned.step.curves[1]!.posed).toEqual(step.curves[1]!.posed);
    await page.keyboard.press('Control+z');
    expect((await curves(desk)).step.curves[1]!.twist).toBeUndefined();
    await page.keyboard.press('w');
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
    await expect(page.locator('.pose-picture[src]')).toHaveCount(2);
    await desk.picture('curves-poses');
  });

  await test.step('the end of an arm slides along it', async () => {
    await desk.command('All back to rest');
    await page.keyboard.press('t');
    const before = (await curves(desk)).step.curves[2]!.rest;
    const [from, to] = await desk.project(before.at(-1)!, before.at(-2)!);
    await page.mouse.move(from!.x, from!.y);
    await desk.picture('curves-hover');
    await desk.drag(from!, { x: to!.x - from!.x, y: to!.y - from!.y });
    const after = (await curves(desk)).step.curves[2]!.rest;
    expect(after.at(-1)![0]).toBeCloseTo(before.at(-2)![0], 0);
    expect(after[0]).toEqual(before[0]);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('w');
  });

  await test.step('the skeleton leaves as a GLB that stands in the pose that is shown', async () => {
    const { step, positions, rest } = await curves(desk);
    expect(gap(positions, rest)).toBeGreaterThan(1);
    await page.keyboard.press('Control+e');
    await expect(page.getByRole('radio', { name: 'GLB with a skeleton' })).toBeChecked();
    await desk.picture('curves-export');
    const download = page.waitForEvent('download');
    await page.getByRole('dialog').getByRole('button', { name: 'Export' }).click();
    const file = await bytesOf(await download);
    const { scene, animations } = await new GLTFLoader().parseAsync(file.slice().buffer as ArrayBuffer, '');
    expect(animations).toHaveLength(1);
    const far = farthest(scene, positions);
    const size = diagonal(rest);
    console.log(
      `the skin of three.js and the app: ${((100 * far) / size).toFixed(2)} % of the diagonal apart`,
    );
    expect(far).toBeLessThan(0.01 * size);
    expect(step.poses).toHaveLength(2);
  });
});

/** A quarter of the way round the ring that twists the selected point of a curve, on screen. */
async function twistRing(desk: Desk, at: number): Promise<{ x: number; y: number }[]> {
  const { step } = await curves(desk);
  const points = step.curves[at]!.posed ?? step.curves[at]!.rest;
  const place = points.at(-1)!;
  const z = tangentAt(points, points.length - 1);
  const x = anyNormal(z);
  const y = cross(z, x);
  const pixel = await desk.page.evaluate(
    (point) => window.__lissom.app.viewport!.pixelSize(point),
    place as Vec3,
  );
  const radius = RING * pixel;
  const around = (angle: number): Vec3 =>
    [0, 1, 2].map(
      (k) => place[k]! + radius * (Math.cos(angle) * x[k]! + Math.sin(angle) * y[k]!),
    ) as unknown as Vec3;
  return desk.project(...Array.from({ length: 10 }, (_, k) => around((k * Math.PI) / 18)));
}

/** How far three.js draws any vertex from where the app has it. */
function farthest(scene: Object3D, positions: Float64Array): number {
  let most = 0;
  scene.updateMatrixWorld(true);
  scene.traverse((object) => {
    const mesh = object as SkinnedMesh;
    if (!mesh.isSkinnedMesh) return;
    mesh.skeleton.update();
    const at = new Vector3();
    const { count } = mesh.geometry.attributes.position!;
    for (let v = 0; v < count; v++) {
      mesh.getVertexPosition(v, at).applyMatrix4(mesh.matrixWorld);
      let nearest = Infinity;
      for (let i = 0; i < positions.length; i += 3)
        nearest = Math.min(
          nearest,
          Math.hypot(at.x - positions[i]!, at.y - positions[i + 1]!, at.z - positions[i + 2]!),
        );
      most = Math.max(most, nearest);
    }
  });
  return most;
}
