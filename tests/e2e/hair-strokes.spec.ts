import { expect, SIZE, test } from './desk';
import { along, beside, draw, drawAt, enter, grownHere, hair, type Spot, spots, type } from './hair-desk';

const COUNT = 500;
/** From above the forehead down one side, as the head is seen at first. */
const SIDE: readonly Spot[] = [
  [0.02, -0.55],
  [0.22, -0.45],
  [0.34, -0.15],
  [0.36, 0.15],
];

// Each on a page of its own.
test.describe.configure({ mode: 'parallel' });
test.use({ viewport: SIZE });

test('a stroke on the head grows hair, hint strokes change it, and everything can be undone', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await enter(desk, COUNT);
  const bare = await hair(desk);
  expect(bare.step.streams).toEqual([]);

  await drawAt(desk, ...SIDE);
  const grown = await hair(desk);
  const { points } = grown.step.streams[0]!;
  expect(grown.step.streams).toHaveLength(1);
  expect(grown.strands).toBe(COUNT);
  expect(grown.hash).not.toBe(bare.hash);
  expect(await grownHere(grown.recipe)).toBe(grown.hash);
  await desk.picture('hair-one-stroke');

  await test.step('undo and redo bring back the same bytes', async () => {
    await desk.press('Control+z');
    expect((await hair(desk)).step.streams).toEqual([]);
    await desk.press('Control+Shift+Z');
    expect((await hair(desk)).hash).toBe(grown.hash);
  });

  await test.step('a slip of the hand and a stroke beside the head cost nothing', async () => {
    const [on, off] = await spots(page, SIDE[1]!, [-0.9, 0.85]);
    const { entries } = await desk.history();
    await desk.drag(on!, { x: 1, y: 1 });
    await expect(page.locator('.toast').last()).toContainText('too short for a curve');
    await page.mouse.move(off!.x, off!.y);
    await expect(page.getByText('start on the head to draw')).toBeVisible();
    expect((await hair(desk)).hash).toBe(grown.hash);
    expect((await desk.history()).entries).toBe(entries);
  });

  await desk.press('e');
  const taken = async (): Promise<void> => {
    await desk.press('Control+z');
    expect((await hair(desk)).hash).toBe(grown.hash);
  };
  await test.step('a hint stroke across the curve cuts it', async () => {
    const [at] = await along(desk, points, 0.5);
    await draw(desk, beside(at!, -40, -24), beside(at!, 40, 24));
    const cut = await hair(desk);
    expect(cut.step.streams[0]!.points.length).toBeLessThan(points.length);
    expect(cut.step.streams[0]!.points[0]).toEqual(points[0]);
    expect(cut.hash).not.toBe(grown.hash);
    await taken();
  });

  await test.step('one that leads away from it continues it from there', async () => {
    const [at] = await along(desk, points, 0.7);
    await draw(desk, at!, beside(at!, 20, 30), beside(at!, 60, 50));
    const { step, hash } = await hair(desk);
    expect(step.streams[0]!.points[0]).toEqual(points[0]);
    const [was, end] = await desk.project(
      points.at(-1) as [number, number, number],
      step.streams[0]!.points.at(-1) as [number, number, number],
    );
    expect(Math.hypot(end!.x - at!.x - 60, end!.y - at!.y - 50)).toBeLessThan(6);
    expect(Math.hypot(end!.x - was!.x, end!.y - was!.y)).toBeGreaterThan(10);
    expect(hash).not.toBe(grown.hash);
    await taken();
  });

  await test.step('one that leaves it and comes back replaces what lies between', async () => {
    const [from, middle, to] = await along(desk, points, 0.3, 0.6, 0.9);
    await draw(desk, from!, beside(middle!, 45, -20), to!);
    const { step, hash } = await hair(desk);
    const changed = step.streams[0]!.points;
    expect(changed[0]).toEqual(points[0]);
    expect(changed.at(-1)).toEqual(points.at(-1));
    expect(changed).not.toEqual(points);
    expect(hash).not.toBe(grown.hash);
    await desk.picture('hair-hint-insert');
    await taken();
  });

  await test.step('a control point can be dragged, and its neighbours follow', async () => {
    await desk.press('v');
    const middle = Math.round(0.6 * (points.length - 1));
    const [at] = await along(desk, points, 0.6);
    await draw(desk, at!, beside(at!, 24, 6));
    const dragged = (await hair(desk)).step.streams[0]!.points;
    expect(dragged).toHaveLength(points.length);
    expect(dragged[0]).toEqual(points[0]);
    for (const near of [middle - 1, middle, middle + 1]) expect(dragged[near]).not.toEqual(points[near]);
    await taken();
  });

  await test.step('curl changes the strands, colour only how they look', async () => {
    await type(desk, 'Curl', 0.5);
    const curly = await hair(desk);
    expect(curly.step.detail.curl).toBe(0.5);
    expect(curly.hash).not.toBe(grown.hash);
    await page.getByRole('button', { name: 'Ginger' }).click();
    const ginger = await hair(desk);
    expect(ginger.color).not.toBe(curly.color);
    expect(ginger.hash).toBe(curly.hash);
  });

  await test.step('a deleted curve leaves a bare field, and undo brings it back', async () => {
    await desk.press('Delete');
    expect((await hair(desk)).step.streams).toEqual([]);
    await desk.press('Control+z');
    expect((await hair(desk)).step.streams).toHaveLength(1);
  });
});

test('a parting and a ponytail are drawn stroke by stroke', async ({ fresh: desk }) => {
  await enter(desk, COUNT);
  await drawAt(desk, ...SIDE);
  const before = await hair(desk);

  await test.step('a parting', async () => {
    await desk.press('p');
    await drawAt(desk, [0.02, -0.42], [0.02, -0.5], [0.02, -0.58]);
    const parted = await hair(desk);
    expect(parted.step.partings).toHaveLength(1);
    expect(parted.hash).not.toBe(before.hash);
  });

  await test.step('a ponytail: spine, cross-section, a profile on either side', async () => {
    await desk.press('t');
    await drawAt(desk, [0.1, -0.6], [0.3, -0.75], [0.6, -0.6], [0.7, -0.1]);
    const spine = (await hair(desk)).step.ponytails[0]!.spine;
    const [low, middle, end] = await along(desk, spine, 0.3, 0.6, 1);
    await draw(desk, beside(low!, -14, 14), beside(low!, 14, -14));
    expect((await hair(desk)).step.ponytails[0]!.section.length).toBeGreaterThan(2);
    await draw(desk, beside(low!, 12, -12), beside(middle!, 22, -16), beside(end!, 14, 0));
    await draw(desk, beside(low!, -12, 12), beside(middle!, -18, 16), beside(end!, -14, 0));
    const tied = await hair(desk);
    expect(tied.step.ponytails[0]!.profiles.map((profile) => profile.length > 1)).toEqual([true, true]);
    expect(await grownHere(tied.recipe)).toBe(tied.hash);
    await desk.picture('hair-ponytail-drawn');
  });

  await test.step('undo takes it back stroke by stroke', async () => {
    for (const drawn of [1, 0]) {
      await desk.press('Control+z');
      const { profiles } = (await hair(desk)).step.ponytails[0]!;
      expect(profiles.filter((profile) => profile.length > 0)).toHaveLength(drawn);
    }
    await desk.press('Control+z');
    expect((await hair(desk)).step.ponytails[0]!.section).toEqual([]);
    await desk.press('Control+z');
    expect((await hair(desk)).step.ponytails).toEqual([]);
  });
});
