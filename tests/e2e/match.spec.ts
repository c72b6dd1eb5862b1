import type { Mesh } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import type { MatchWing } from '../../web/app/match/wing';
import { readModel } from '../../web/io/formats';
import { readZip } from '../../web/io/zip';
import type { Vec3 } from '../../web/view/types';
import { serious } from './axe';
import { bytesOf, type Desk, expect, test } from './desk';
import { chooseFruit, fileOf, matched, shownModels, spotOn, suggested } from './match-desk';

test.slow();
test.use({ viewport: { width: 1100, height: 680 } });

/** In sight from where the camera stands at first. */
const SPOTS: readonly Vec3[] = [
  [0, 0, 1],
  [0.55, 0.45, 0.7],
  [-0.25, 0.5, 0.8],
  [0.7, -0.5, 0.55],
  [0.1, -0.5, 0.85],
  [0.25, 0.85, 0.45],
];

/** Clicks places of the ball on the pear, then on the plum. */
async function mark(desk: Desk, spots: readonly Vec3[]): Promise<void> {
  for (const spot of spots)
    for (const [at, fruit] of (['pear', 'plum'] as const).entries()) {
      const { x, y } = await spotOn(desk, at, fruit, spot);
      await desk.page.mouse.click(x, y);
      await desk.settled();
    }
}

const run = (desk: Desk) => desk.page.getByRole('button', { name: /^Match( again)?$/ }).last();

test('two fruits get one connectivity: marked, suggested, matched, moved, undone, bent and written', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await chooseFruit(desk, 'pear', 'plum');
  await desk.picture('match-start');
  expect((await matched(desk)).step).toMatchObject({ models: ['pear', 'plum'], markers: [] });

  await test.step('a marker waits for its counterpart, which is suggested', async () => {
    const { x, y } = await spotOn(desk, 0, 'pear', SPOTS[0]!);
    await page.mouse.click(x, y);
    const { step, selected } = await matched(desk);
    expect(step.markers).toEqual([[expect.anything(), null]]);
    expect(selected).toBe(0);
    await expect(page.getByText('not on plum')).toBeVisible();
    await expect(page.getByText('Where is 1 here?')).toBeVisible();
    await suggested(desk);
    await desk.picture('match-suggested');
    await desk.press('Enter');
    const accepted = await matched(desk);
    expect(accepted.step.markers[0]!.every((place) => place !== null)).toBe(true);
    expect((await desk.history()).index).toBe(3);
    await desk.press('Control+z');
    expect((await matched(desk)).step.markers).toEqual([[expect.anything(), null]]);
    await desk.press('Control+Shift+z');
  });

  await test.step('the others by clicks; with fewer than three there is nothing to run', async () => {
    await expect(page.getByText('2 more markers, then the models can be matched')).toBeVisible();
    await expect(run(desk)).toBeDisabled();
    await mark(desk, SPOTS.slice(1));
    await desk.picture('match-marked');
    const { step } = await matched(desk);
    expect(step.markers).toHaveLength(6);
    expect(step.markers.flat().every((place) => place !== null)).toBe(true);
  });

  await test.step('it is matched when the button is pressed', async () => {
    expect((await matched(desk)).skin).toBe(0);
    await run(desk).click();
    const { quality, skin, outdated, problem } = await matched(desk);
    expect([outdated, problem]).toEqual([false, null]);
    expect(skin).toBeGreaterThan(100);
    for (const { mean, flipped } of quality) {
      expect(mean).toBeLessThan(0.01);
      expect(flipped).toBe(0);
    }
    await expect(page.getByRole('heading', { name: 'Quality' })).toBeVisible();
    await desk.picture('match-done');
    await page.keyboard.press('e');
    await expect(page.getByText('Distance from the model')).toBeVisible();
    await page.getByRole('group', { name: 'plum shows' }).getByRole('button', { name: 'Skin' }).click();
    await desk.picture('match-heat');
    await page.keyboard.press('e');
  });
  const first = await matched(desk);

  await test.step('a marker that is dragged leaves the skins, and says that they are out of date', async () => {
    const from = await spotOn(desk, 1, 'plum', SPOTS[1]!);
    await desk.drag(from, { x: 14, y: 8 });
    const { step, outdated, skin } = await matched(desk);
    expect(step.markers).toHaveLength(6);
    expect(step.markers[1]![1]).not.toEqual(first.step.markers[1]![1]);
    expect(step.markers[1]![0]).toEqual(first.step.markers[1]![0]);
    expect([outdated, skin]).toEqual([true, first.skin]);
    await expect(page.getByText('Something was changed since')).toBeVisible();
    await desk.picture('match-outdated');
    await desk.press('Control+z');
    expect(await matched(desk)).toMatchObject({ outdated: false, skin: first.skin });
  });

  await test.step('a selected marker is removed by its key, and back by undo', async () => {
    await page.getByRole('button', { name: 'Marker 2' }).first().click();
    await desk.press('Delete');
    expect((await matched(desk)).step.markers).toHaveLength(5);
    await desk.press('Control+z');
    expect((await matched(desk)).step.markers).toHaveLength(6);
  });

  await test.step('all skins go into one GLB, the others as morph targets', async () => {
    const file = await exported(desk, 'GLB with morph targets');
    const { scene } = await new GLTFLoader().parseAsync(file.slice().buffer as ArrayBuffer, '');
    const meshes: Mesh[] = [];
    scene.traverse((node) => {
      if ('isMesh' in node) meshes.push(node as Mesh);
    });
    const [mesh] = meshes;
    expect(mesh!.morphTargetDictionary).toEqual({ plum: 0 });
    expect(mesh!.geometry.morphAttributes.position![0]!.count).toBe(first.skin);
    expect(mesh!.geometry.attributes.position!.count).toBe(first.skin);
  });

  await test.step('or as files with one list of faces', async () => {
    const files = readZip(await exported(desk, 'OBJ, zipped'), { bytes: 1e8, files: 9 });
    expect([...files.keys()]).toEqual(['pear.obj', 'plum.obj']);
    const [a, b] = [...files].map(([name, bytes]) => readModel(bytes, name).model);
    expect(a!.positions).toHaveLength(3 * first.skin);
    expect(b!.faceVertices).toEqual(a!.faceVertices);
    expect(b!.positions).not.toEqual(a!.positions);
  });

  await test.step('either skin is bent, and the match is still there', async () => {
    await page.getByLabel('Skin to go on with').selectOption({ label: 'plum' });
    await page.locator('.side-panel').getByRole('button', { name: 'Deform', exact: true }).click();
    await desk.settled();
    const { step, rest } = await desk.shown();
    expect(step).toMatchObject({ type: 'deform', model: 'match 1/plum' });
    expect(rest).toHaveLength(3 * first.skin);
    await page.getByRole('navigation').getByRole('button', { name: 'Match', exact: true }).click();
    expect(await matched(desk)).toMatchObject({ outdated: false, skin: first.skin });
  });

  await test.step('opened again, it is matched without being asked', async () => {
    await page.waitForFunction(() => window.__lissom.app.state.saved.peek().kind === 'saved');
    await page.reload();
    await desk.ready();
    await page.getByRole('navigation').getByRole('button', { name: 'Match', exact: true }).click();
    await page.waitForFunction(() => {
      const wing = window.__lissom.app.wings.get('match') as MatchWing | undefined;
      return wing?.state.result.peek();
    });
    expect((await matched(desk)).skin).toBe(first.skin);
  });
});

async function exported(desk: Desk, choice: string): Promise<Uint8Array> {
  const { page } = desk;
  await expect(page.getByRole('dialog')).toHaveCount(0);
  await desk.settled();
  await page.keyboard.press('Control+e');
  await expect(page.getByRole('dialog')).toBeVisible();
  await page.getByText(choice, { exact: true }).click();
  const download = page.waitForEvent('download');
  await page.getByRole('dialog').getByRole('button', { name: 'Export', exact: true }).click();
  return bytesOf(await download);
}

test('lines, masks and mirror markers; three models, another first one, one less', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await chooseFruit(desk, 'pear', 'plum');

  await test.step('a marker beside the plane of symmetry has a partner', async () => {
    await page.keyboard.press('m');
    for (const [at, fruit] of (['pear', 'plum'] as const).entries()) {
      const { x, y } = await spotOn(desk, at, fruit, [0.5, 0.2, 0.8]);
      await page.mouse.click(x, y);
      await desk.settled();
    }
    const { step } = await matched(desk);
    expect(step.markers).toHaveLength(2);
    expect(step.markers.flat().every((place) => place !== null)).toBe(true);
    await page.keyboard.press('m');
  });

  await test.step('a line is drawn on each model', async () => {
    await page.keyboard.press('c');
    for (const [at, fruit] of (['pear', 'plum'] as const).entries()) {
      const from = await spotOn(desk, at, fruit, [-0.5, 0, 0.8]);
      const to = await spotOn(desk, at, fruit, [0.5, -0.2, 0.8]);
      await desk.drag(from, { x: to.x - from.x, y: to.y - from.y }, 12);
      const { step } = await matched(desk);
      expect(step.curves).toHaveLength(1);
      expect(step.curves![0]![at]!.length).toBeGreaterThan(4);
      expect(step.curves![0]!.filter(({ length }) => length > 0)).toHaveLength(at + 1);
    }
    await desk.picture('match-line');
  });

  await test.step('what is painted is ignored', async () => {
    await page.keyboard.press('b');
    const from = await spotOn(desk, 1, 'plum', [0, 0.6, 0.8]);
    await desk.drag(from, { x: 20, y: 0 });
    const { step } = await matched(desk);
    expect(step.mask).toHaveLength(2);
    expect(step.mask![0]).toEqual([]);
    expect(JSON.stringify(step.mask![1]).length).toBeGreaterThan(4);
    await page.getByRole('button', { name: 'Ignore nothing of plum' }).click();
    expect((await matched(desk)).step.mask).toBeUndefined();
  });

  await test.step('a third model joins, on which everything is still to be marked', async () => {
    await desk.command('Add a model');
    await desk.choose(fileOf('fig'));
    await shownModels(desk, 3);
    const { step } = await matched(desk);
    expect(step.models).toEqual(['pear', 'plum', 'fig']);
    expect(step.markers.map((marker) => marker[2])).toEqual([null, null]);
    expect(step.curves![0]![2]).toEqual([]);
    await page.getByRole('button', { name: 'Marker 1' }).first().click();
    await expect(page.getByText('Where is 1 here?')).toBeVisible();
    await suggested(desk);
    expect((await matched(desk)).ghosts).toEqual([2]);
    await desk.picture('match-three');
    await page.getByRole('button', { name: 'Take it' }).click();
    expect((await matched(desk)).step.markers[0]![2]).not.toBeNull();
  });

  await test.step('another one is the first, and one is left out', async () => {
    const before = (await matched(desk)).step;
    await page.getByRole('button', { name: 'More about fig' }).click();
    await page.getByRole('menuitem', { name: 'Start from this one' }).click();
    const { step } = await matched(desk);
    expect(step.models).toEqual(['fig', 'pear', 'plum']);
    expect(step.markers).toEqual(before.markers.map(([a, b, c]) => [c, a, b]));
    await page.getByRole('button', { name: 'More about pear' }).click();
    await page.getByRole('menuitem', { name: 'Leave it out' }).click();
    await shownModels(desk, 2);
    expect((await matched(desk)).step.models).toEqual(['fig', 'plum']);
    await desk.press('Control+z');
    await desk.press('Control+z');
    expect((await matched(desk)).step).toEqual(before);
  });

  await test.step('nothing in the workspace keeps anybody out', async () => {
    for (const theme of ['dark', 'light']) {
      expect(await serious(desk), theme).toEqual([]);
      await desk.command('theme');
    }
  });
});
