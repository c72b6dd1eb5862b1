import type { CurvesWing } from '../../web/app/curves/wing';
import { encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import type { CurvesStep } from '../../web/recipe/recipe';
import type { Vec3 } from '../../web/view/types';
import { Desk, diagonal, expect, forTest, gap, type Place, test, visitorAt, withoutPickers } from './desk';
import { bumpyObj } from './shapes';

test.slow();

const HEAD = parseRecipe(
  JSON.stringify({
    lissom: 1,
    models: { head: { builtin: 'head-female' } },
    steps: [{ id: 'curves 1', type: 'curves', model: 'head', curves: [] }],
    outputs: [],
  }),
);

/** What is drawn, and what is in hand. */
async function drawn(desk: Desk) {
  const read = await desk.page.evaluate(() => {
    const { app } = window.__lissom;
    const { state, actions } = app.wings.get('curves') as CurvesWing;
    const { contours } = state;
    const lines = contours.lines.peek();
    const hand = contours.hand.peek();
    return {
      lines: lines && {
        points: [...lines.points],
        offsets: [...lines.offsets],
        suggestive: [...lines.suggestive],
        seconds: lines.seconds,
      },
      hand: hand && { span: [...hand.picked.span], reach: hand.picked.reach, curve: hand.curve },
      line: actions.hand.line()?.map((point) => [...point]) ?? null,
      weights: contours.weights.peek() && [...contours.weights.peek()!],
      status: app.state.status.peek(),
      steps: JSON.stringify(app.document.recipe.steps),
      pull: JSON.stringify(state.step.peek()!),
    };
  });
  return {
    ...read,
    line: read.line as Vec3[] | null,
    steps: JSON.parse(read.steps) as CurvesStep[],
    pull: JSON.parse(read.pull) as CurvesStep,
  };
}

async function shape(desk: Desk) {
  await desk.settled();
  const read = await desk.page.evaluate(() => {
    const { shown, positions } = window.__lissom.app.evaluator.result.peek()!;
    return { rest: [...shown.model.positions], positions: [...positions] };
  });
  return { rest: Float64Array.from(read.rest), positions: Float64Array.from(read.positions) };
}

/** A place in the middle of a line in sight: the longest whose middle lies in the wanted part of the window. */
async function lineAt(desk: Desk, low: Place, high: Place): Promise<Place> {
  const place = await desk.page.evaluate(
    ([from, to]) => {
      const { app } = window.__lissom;
      const lines = (app.wings.get('curves') as CurvesWing).state.contours.lines.peek()!;
      const view = app.viewport!;
      const box = document.querySelector('canvas')!.getBoundingClientRect();
      let best: { x: number; y: number; length: number } | null = null;
      for (let l = 0; l + 1 < lines.offsets.length; l++) {
        const [first, end] = [lines.offsets[l]!, lines.offsets[l + 1]!];
        const middle = Math.floor((first + end) / 2);
        const point = [0, 1, 2].map((k) => lines.points[3 * middle + k]!) as [number, number, number];
        const { x, y } = view.project(point);
        const met = view.pick(x, y);
        const off = met ? Math.hypot(...met.point.map((c, k) => c - point[k]!)) : Infinity;
        const within =
          box.left + x > from!.x && box.left + x < to!.x && box.top + y > from!.y && box.top + y < to!.y;
        if (!within || off > 4 * view.pixelSize(point)) continue;
        if (!best || end - first > best.length)
          best = { x: box.left + x, y: box.top + y, length: end - first };
      }
      return best;
    },
    [low, high],
  );
  if (!place) throw new Error('no line is in sight there');
  return place;
}

async function linesSettled(desk: Desk): Promise<void> {
  await desk.settled();
  await expect.poll(async () => (await drawn(desk)).lines?.offsets.length ?? 0).toBeGreaterThan(3);
  await desk.page.waitForTimeout(600);
}

test('a line of the view is picked, trimmed and pulled; the surface beside it goes along, and back', async ({
  page,
  browser,
  baseURL,
}) => {
  const desk = new Desk(await withoutPickers(page));
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await desk.open(forTest(encodeLink(HEAD, baseURL!)));
  await page.keyboard.press('n');
  await linesSettled(desk);
  await desk.picture('contours-dark');
  const { rest } = await shape(desk);
  const size = diagonal(rest);

  await test.step('lines are there, some of them suggestive, and follow a turn of the view', async () => {
    const before = (await drawn(desk)).lines!;
    expect(before.suggestive.length).toBeGreaterThan(8);
    expect(before.suggestive).toContain(0);
    expect(before.suggestive).toContain(1);
    await desk.drag({ x: 160, y: 700 }, { x: 70, y: 0 }, 8);
    await linesSettled(desk);
    const after = (await drawn(desk)).lines!;
    expect(after.points).not.toEqual(before.points);
    await desk.picture('contours-turned');
    await desk.command('Suggestive contours');
    await expect.poll(async () => (await drawn(desk)).lines!.suggestive.includes(1)).toBe(false);
    await desk.command('Suggestive contours');
    await expect.poll(async () => (await drawn(desk)).lines!.suggestive.includes(1)).toBe(true);
  });

  const at = await lineAt(desk, { x: 450, y: 180 }, { x: 800, y: 700 });
  await test.step('the line under the pointer lights up, a click takes it in hand', async () => {
    await page.mouse.move(at.x, at.y);
    await expect.poll(async () => (await drawn(desk)).status).toContain('Click to pick this line');
    await desk.picture('contours-hover');
    await page.mouse.click(at.x, at.y);
    await expect.poll(async () => (await drawn(desk)).weights?.some((w) => w > 0.9)).toBe(true);
    await desk.picture('contours-picked');
    // Nothing of it is in the document yet.
    expect((await drawn(desk)).steps).toHaveLength(1);
    expect((await drawn(desk)).steps[0]!.curves).toEqual([]);
  });

  await test.step('an end is dragged along it, the ring makes the reach smaller', async () => {
    const { line, hand } = await drawn(desk);
    const [end, inner] = await desk.project(line!.at(-1)!, line![Math.floor(0.7 * line!.length)]!);
    await desk.drag(end!, { x: inner!.x - end!.x, y: inner!.y - end!.y }, 6);
    const trimmed = (await drawn(desk)).hand!;
    expect(trimmed.span[1]).toBeLessThan(hand!.span[1]! - 0.15 * (hand!.span[1]! - hand!.span[0]!));
    expect(trimmed.span[0]).toBe(hand!.span[0]);
    const slider = page.getByRole('slider', { name: 'Reach, %' });
    await slider.focus();
    for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowLeft');
    await expect.poll(async () => (await drawn(desk)).hand!.reach).toBeLessThan(trimmed.reach);
    await desk.picture('contours-trimmed');
  });

  const grab = async (): Promise<Place> => {
    const { line } = await drawn(desk);
    const [place] = await desk.project(line![Math.floor(line!.length / 2)]!);
    return place!;
  };
  const by = { x: 6, y: -26 };

  await test.step('Escape takes a pull back', async () => {
    await desk.hold(await grab(), by, 6);
    await desk.settled();
    expect(gap((await shape(desk)).positions, rest)).toBeGreaterThan(0.001 * size);
    await page.keyboard.press('Escape');
    await page.mouse.up();
    expect(gap((await shape(desk)).positions, rest)).toBe(0);
    expect((await drawn(desk)).hand).not.toBeNull();
  });

  await test.step('the line goes with the pointer, the surface with the line', async () => {
    const from = await grab();
    await desk.hold(from, by, 6);
    await desk.settled();
    const now = await grab();
    expect(Math.hypot(now.x - from.x - by.x, now.y - from.y - by.y)).toBeLessThan(1.5);
    await desk.picture('contours-pulling');
    await page.mouse.up();
    await linesSettled(desk);
    await desk.picture('contours-pulled');
  });

  const pulled = await shape(desk);
  await test.step('only what is near the line has moved', async () => {
    const { pull } = await drawn(desk);
    const [curve] = pull.curves;
    expect(curve).toMatchObject({ kind: 'contour' });
    let count = 0;
    let most = 0;
    for (let v = 0; 3 * v < rest.length; v++) {
      const point = [0, 1, 2].map((k) => rest[3 * v + k]!);
      const by = Math.hypot(...point.map((x, k) => pulled.positions[3 * v + k]! - x));
      most = Math.max(most, by);
      if (by === 0) continue;
      count++;
      const away = Math.min(...curve!.rest.map((p) => Math.hypot(...p.map((x, k) => x - point[k]!))));
      expect(away).toBeLessThan(1.6 * curve!.reach!);
    }
    expect(count).toBeGreaterThan(20);
    expect(count).toBeLessThan(rest.length / 6);
    const shift = Math.hypot(...curve!.posed![0]!.map((x, k) => x - curve!.rest[0]![k]!));
    expect(most).toBeGreaterThan(0.8 * shift);
    expect(most).toBeLessThan(1.01 * shift);
  });

  await test.step('one undo takes it back, one redo brings it again', async () => {
    await page.keyboard.press('Control+z');
    expect(gap((await shape(desk)).positions, rest)).toBe(0);
    await page.keyboard.press('Control+Shift+z');
    expect(gap((await shape(desk)).positions, pulled.positions)).toBe(0);
  });

  await test.step('the next line is pulled on the new surface, in a step of its own', async () => {
    await page.keyboard.press('Escape');
    await linesSettled(desk);
    const other = await lineAt(desk, { x: 400, y: 120 }, { x: 860, y: 760 });
    await desk.drag(other, { x: 20, y: 4 }, 5);
    const { steps } = await drawn(desk);
    expect(steps).toHaveLength(2);
    expect(steps[1]).toMatchObject({ type: 'curves', model: 'curves 1', curves: [{ kind: 'contour' }] });
    await linesSettled(desk);
    await desk.picture('contours-pulled-again');
  });

  await test.step('the link opens to the same bytes', async () => {
    const sent = await shape(desk);
    const link = await desk.copiedLink();
    const visitor = await visitorAt(browser, link);
    await expect.poll(async () => gap((await shape(visitor)).positions, sent.positions)).toBe(0);
    await visitor.page.context().close();
  });
});

test('by light the drawing is ink on white', async ({ page, baseURL }) => {
  const desk = new Desk(await withoutPickers(page));
  await desk.open(forTest(encodeLink(HEAD, baseURL!)));
  await desk.command('light or dark');
  await page.keyboard.press('n');
  await linesSettled(desk);
  await desk.picture('contours-light');
  const at = await lineAt(desk, { x: 450, y: 180 }, { x: 800, y: 700 });
  await page.mouse.click(at.x, at.y);
  await expect.poll(async () => (await drawn(desk)).weights !== null).toBe(true);
  await page.mouse.move(at.x + 120, at.y + 60);
  await desk.picture('contours-light-picked');
});

test('lines of 50,000 vertices follow while the view turns; how often is printed', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await page.setViewportSize({ width: 920, height: 340 });
  await desk.choose(['bumpy.obj', bumpyObj(160, 314)]);
  await desk.command('Curves workspace');
  await page.keyboard.press('n');
  await linesSettled(desk);
  // Counted in the page: answers, and pictures, while the view turns.
  await page.evaluate(() => {
    const { app } = window.__lissom;
    const { lines } = (app.wings.get('curves') as CurvesWing).state.contours;
    const counts = { answers: -1, pictures: 0, first: 0, last: 0, kernel: 0 };
    Object.assign(window, { counts });
    lines.subscribe((found) => {
      counts.answers++;
      counts.kernel += found?.seconds ?? 0;
      counts.last = performance.now();
      if (counts.answers === 0) counts.first = counts.last;
    });
    app.viewport!.onDraw(() => counts.pictures++);
  });
  await page.mouse.move(70, 240);
  await page.mouse.down();
  const until = Date.now() + 4000;
  for (let i = 1; Date.now() < until; i++) await page.mouse.move(70 + (i % 60), 240);
  await page.mouse.up();
  await page.waitForTimeout(400);
  const { answers, pictures, first, last, kernel } = (await page.evaluate(
    () => (window as unknown as { counts: Record<string, number> }).counts as never,
  )) as Record<'answers' | 'pictures' | 'first' | 'last' | 'kernel', number>;
  const rate = (1000 * answers) / (last - first);
  console.log(
    `50,240 vertices: ${answers} drawings and ${pictures} pictures, ${rate.toFixed(1)} a second; ${((1000 * kernel) / (answers + 1)).toFixed(1)} ms in the kernel each`,
  );
  await desk.picture('contours-50k');
  // Some came while the view turned, not only the last one when it stood still.
  expect(answers).toBeGreaterThan(2);
});
