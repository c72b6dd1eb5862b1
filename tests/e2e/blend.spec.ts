import type { BlendWing } from '../../web/app/blend/wing';
import type { BlendStep } from '../../web/recipe/recipe';
import { serious } from './axe';
import { bytesOf, type Desk, diagonal, expect, gap, test } from './desk';
import { FIGURE_FILES, MATCHED, NAMES } from './figures';

test.slow();
test.use({ viewport: { width: 1240, height: 860 } });

interface Blended {
  readonly step: BlendStep;
  readonly positions: Float64Array;
  /** Of each skin. */
  readonly skins: readonly Float64Array[];
  readonly figures: { readonly weights: Readonly<Record<string, number>> } | null;
  readonly problem: string | null;
  readonly selected: number | null;
}

async function blended(desk: Desk): Promise<Blended> {
  await desk.settled();
  await desk.page.waitForFunction(() => {
    const { state } = window.__lissom.app.wings.get('blend') as BlendWing;
    return state.skins.peek() !== null;
  });
  const read = await desk.page.evaluate(() => {
    const { app } = window.__lissom;
    const { state } = app.wings.get('blend') as BlendWing;
    return {
      step: JSON.stringify(state.step.peek()),
      positions: [...app.evaluator.result.peek()!.positions],
      skins: state.skins.peek()!.positions.map((positions) => [...positions]),
      figures: state.figures.peek(),
      problem: state.problem.peek(),
      selected: app.state.selection.peek().item,
    };
  });
  return {
    ...read,
    step: JSON.parse(read.step) as BlendStep,
    positions: Float64Array.from(read.positions),
    skins: read.skins.map((positions) => Float64Array.from(positions)),
  };
}

/** The sum of the skins by weights. */
function sum({ skins }: Pick<Blended, 'skins'>, weights: Readonly<Record<string, number>>): Float64Array {
  const out = new Float64Array(skins[0]!.length);
  for (const [k, name] of NAMES.entries())
    for (let i = 0; i < out.length; i++) out[i] = out[i]! + (weights[name] ?? 0) * skins[k]![i]!;
  return out;
}

/** What the graphics card has drawn. */
const drawn = (desk: Desk): Promise<Float64Array> =>
  desk.page
    .evaluate(() => {
      const { state } = window.__lissom.app.wings.get('blend') as BlendWing;
      return [...state.readBack()!.positions];
    })
    .then((positions) => Float64Array.from(positions));

const heightOf = (positions: Float64Array): number => {
  const along = positions.filter((_, i) => i % 3 === 1);
  return along.reduce((a, b) => Math.max(a, b)) - along.reduce((a, b) => Math.min(a, b));
};

const enter = async (desk: Desk): Promise<void> => {
  await desk.choose(['figures.json', MATCHED], ...FIGURE_FILES);
  await desk.page.getByRole('navigation').getByRole('button', { name: 'Blend', exact: true }).click();
  await desk.page.waitForFunction(() => {
    const wing = window.__lissom.app.wings.get('blend') as BlendWing | undefined;
    return wing?.state.skins.peek() != null;
  });
};

test('three figures are blended by a dot and by sliders, on the graphics card while the hand moves', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await enter(desk);
  const start = await blended(desk);
  expect(start.problem).toBeNull();
  expect(Object.values(start.step.weights)).toEqual([1 / 3, 1 / 3, 1 / 3]);
  const size = diagonal(start.positions);
  expect(gap(start.positions, sum(start, start.step.weights))).toBeLessThan(1e-9 * size);
  await desk.picture('blend-start');

  const triangle = (await page.locator('.triangle svg').boundingBox())!;
  const middle = { x: triangle.x + triangle.width / 2, y: triangle.y + 0.6 * triangle.height };

  await test.step('a drag of the dot is drawn as it goes, and exact when it ends', async () => {
    const { index } = await desk.history();
    await desk.hold(middle, { x: -40, y: 30 });
    await desk.settled();
    const live = await page.evaluate(() => {
      const { moved, settled } = window.__lissom.app.evaluator.result.peek()!;
      return { table: moved && [...moved.table], settled };
    });
    expect(live.settled).toBe(false);
    const weights = Object.fromEntries(NAMES.map((name, k) => [name, live.table![k]!]));
    expect(gap(await drawn(desk), sum(start, weights))).toBeLessThan(1e-5 * size);
    await page.mouse.up();
    const { step, positions } = await blended(desk);
    expect(step.weights).toEqual(weights);
    expect(gap(positions, sum(start, weights))).toBeLessThan(1e-9 * size);
    expect((await desk.history()).index).toBe(index + 1);
  });

  await test.step('beyond the triangle the dot stays at its edge', async () => {
    await desk.drag(middle, { x: 0, y: 400 });
    const { weights } = (await blended(desk)).step;
    expect(weights.slim).toBe(0);
    expect(weights.stout! + weights.tall!).toBeCloseTo(1, 9);
  });

  await test.step('a picture is all of that model', async () => {
    await page.getByRole('button', { name: 'Nothing but tall' }).first().click();
    const { step, positions } = await blended(desk);
    expect(step.weights).toEqual({ slim: 0, stout: 0, tall: 1 });
    expect(gap(positions, start.skins[2]!)).toBeLessThan(1e-9 * size);
  });

  await test.step('a typed weight makes room for itself, and free ones are said not to sum', async () => {
    const field = page.getByRole('textbox', { name: 'stout', exact: true });
    await field.fill('40');
    await field.press('Enter');
    expect((await blended(desk)).step.weights).toEqual({ slim: 0, stout: 0.4, tall: 0.6 });
    await page.getByRole('switch', { name: 'Weights are free' }).click();
    await field.fill('80');
    await field.press('Enter');
    expect((await blended(desk)).step.weights).toEqual({ slim: 0, stout: 0.8, tall: 0.6 });
    await expect(page.getByText('The weights do not sum to 100 %')).toBeVisible();
    await page.getByRole('button', { name: 'Make the weights sum to 100 %' }).click();
    const { weights } = (await blended(desk)).step;
    expect(Object.values(weights).reduce((a, b) => a + b)).toBeCloseTo(1, 9);
  });

  await test.step('every edit is undone', async () => {
    while ((await desk.history()).index > 1) await desk.press('Control+z');
    const { positions, step } = await blended(desk);
    expect(step.weights).toEqual(start.step.weights);
    expect(gap(positions, start.positions)).toBe(0);
  });
});

test('a part is painted, takes another’s shape, is feathered, renamed and deleted', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await enter(desk);
  await page.getByRole('button', { name: 'Nothing but slim' }).first().click();
  const bare = await blended(desk);
  const size = diagonal(bare.positions);
  await desk.press('b');
  await page.getByLabel('The next part has the shape of').selectOption('stout');
  // Across the middle, where the two differ most.
  const middle = await desk.project([0, 0.6, 0]);
  const canvas = middle[0]!;
  await desk.drag({ x: canvas.x - 24, y: canvas.y }, { x: 48, y: 0 });
  const painted = await blended(desk);
  expect(painted.problem).toBeNull();
  expect(painted.step.parts).toHaveLength(1);
  expect(painted.step.parts[0]).toMatchObject({ from: 'stout', how: 'paste' });
  expect(painted.selected).toBe(0);
  expect(gap(painted.positions, bare.positions)).toBeGreaterThan(0.005 * size);
  await desk.picture('blend-part');

  await test.step('while weights move, what the part adds is drawn with them', async () => {
    const slider = (await page.getByRole('slider', { name: 'tall', exact: true }).boundingBox())!;
    const y = slider.y + slider.height / 2;
    await desk.hold({ x: slider.x + slider.width / 4, y }, { x: slider.width / 4, y: 0 });
    await desk.settled();
    const { weights } = (await blended(desk)).step;
    const expected = sum(bare, weights);
    for (let i = 0; i < expected.length; i++)
      expected[i] = expected[i]! + painted.positions[i]! - bare.positions[i]!;
    expect(gap(await drawn(desk), expected)).toBeLessThan(1e-5 * size);
    await page.mouse.up();
    await desk.settled();
    await desk.press('Control+z');
  });

  await test.step('it is feathered and renamed', async () => {
    const field = page.getByRole('textbox', { name: /^Feather/ });
    await field.fill('0.05');
    await field.press('Enter');
    expect((await blended(desk)).step.parts[0]!.feather).toBe(0.05);
    await page.getByRole('button', { name: 'Rename Part 1' }).click();
    const name = page.getByRole('textbox', { name: 'Rename Part 1' });
    await name.fill('Belly');
    await name.press('Enter');
    expect((await blended(desk)).step.parts[0]!.name).toBe('Belly');
  });

  await test.step('deleted, the shape is as it was', async () => {
    await page.getByRole('button', { name: 'Delete Belly' }).click();
    const { step, positions } = await blended(desk);
    expect(step.parts).toEqual([]);
    expect(gap(positions, bare.positions)).toBe(0);
  });
});

test('a figure is made to measure, and exported', async ({ fresh: desk }) => {
  const { page } = desk;
  await enter(desk);
  await blended(desk);
  await page.getByRole('button', { name: 'Measure a body' }).click();
  const measured = await blended(desk);
  expect(measured.step.measures.map(({ name }) => name)).toEqual(['Height', 'Chest', 'Waist', 'Hips']);
  const height = page.getByRole('textbox', { name: 'Height', exact: true });
  await expect(height).toBeVisible();
  await desk.picture('blend-measures');
  await height.fill('1.2');
  await height.press('Enter');
  const held = await blended(desk);
  expect(held.step.measures[0]!.value).toBe(1.2);
  expect(heightOf(held.positions)).toBeCloseTo(1.2, 2);
  // What was given is kept to where there is room, and the weights that were found are shown.
  expect(held.step.weights).toEqual(measured.step.weights);
  expect(held.figures!.weights).not.toEqual(measured.figures!.weights);
  await page.getByRole('button', { name: 'Move the tape of Waist up' }).click();
  expect((await blended(desk)).step.measures[2]).not.toEqual(measured.step.measures[2]);
  await page.getByRole('button', { name: 'Keep these weights' }).click();
  const kept = await blended(desk);
  expect(kept.step.measures.every(({ value }) => value === undefined)).toBe(true);
  expect(heightOf(kept.positions)).toBeCloseTo(1.2, 2);

  await desk.press('Control+e');
  await page.getByRole('radio', { name: 'OBJ' }).check();
  const saved = page.waitForEvent('download');
  await page.getByRole('dialog').getByRole('button', { name: 'Export' }).click();
  const text = new TextDecoder().decode(await bytesOf(await saved));
  const rows = text.split('\n').filter((line) => line.startsWith('v '));
  expect(rows).toHaveLength(kept.positions.length / 3);
  const written = Float64Array.from(rows.flatMap((row) => row.split(' ').slice(1, 4).map(Number)));
  expect(gap(written, kept.positions)).toBeLessThan(1e-5);
});

test('a length is measured by two clicks, made straight, held, removed and undone', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await page.setViewportSize({ width: 1440, height: 900 });
  await enter(desk);
  const { positions } = await blended(desk);
  // The front of the figure, low and high.
  const front = (share: number) => {
    const height = heightOf(positions);
    let [best, least] = [0, Infinity];
    for (let v = 0; v < positions.length / 3; v++) {
      const off = Math.abs(positions[3 * v + 1]! - share * height) - 0.5 * positions[3 * v + 2]!;
      if (off < least) [best, least] = [v, off];
    }
    return best;
  };
  const [low, high] = [front(0.3), front(0.75)];
  await page.keyboard.press('l');
  const from = await desk.spot(low);
  const to = await desk.spot(high);
  await page.mouse.click(from.x, from.y);
  await page.mouse.move(to.x, to.y);
  await page.waitForTimeout(300);
  await desk.picture('length-begun');
  await page.mouse.click(to.x, to.y);
  const measured = await blended(desk);
  const [measure] = measured.step.measures;
  expect(measure).toMatchObject({ kind: 'length', path: expect.arrayContaining([low, high]) });
  const length = page.getByRole('textbox', { name: 'Length 1', exact: true });
  await expect(length).toBeVisible();
  const along = Number(await length.inputValue());
  await page.getByRole('button', { name: 'Measure Length 1 straight through' }).click();
  expect((await blended(desk)).step.measures).toEqual([{ kind: 'length', path: [low, high] }]);
  expect(Number(await length.inputValue())).toBeLessThan(along);
  await length.fill('0.5');
  await length.press('Enter');
  expect((await blended(desk)).step.measures[0]!.value).toBe(0.5);
  await desk.picture('length-held');
  await page.setViewportSize({ width: 860, height: 700 });
  await page.waitForTimeout(400);
  await desk.picture('length-small');
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.getByRole('button', { name: 'Remove Length 1' }).click();
  expect((await blended(desk)).step.measures).toEqual([]);
  for (let undo = 0; undo < 3; undo++) await desk.press('Control+z');
  expect((await blended(desk)).step.measures).toEqual([measure]);
});

test('without a match the workspace says what is missing, and leads there', async ({ desk }) => {
  const { page } = desk;
  await page.getByRole('navigation').getByRole('button', { name: 'Blend', exact: true }).click();
  expect(await desk.toast()).toContain('Nothing can be blended yet');
  await page.locator('.toast').getByRole('button', { name: 'Match models' }).click();
  await expect(page.getByRole('navigation').getByRole('button', { name: 'Match' })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
});

test('axe finds nothing serious', async ({ fresh: desk }) => {
  await enter(desk);
  expect(await serious(desk)).toEqual([]);
});
