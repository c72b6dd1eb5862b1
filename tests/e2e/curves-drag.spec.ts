import type { CurvesWing } from '../../web/app/curves/wing';
import type { CurvesStep } from '../../web/recipe/recipe';
import type { Vec3 } from '../../web/view/types';
import { type Desk, diagonal, expect, gap, SIZE, test } from './desk';
import { pictureTimes } from './picture-times';
import { limbsObj, tubeObj } from './shapes';

test.use({ viewport: SIZE });
test.slow();

const line = (from: Vec3, to: Vec3, count: number) =>
  Array.from({ length: count }, (_, i) => from.map((x, k) => x + ((to[k]! - x) * i) / (count - 1)));

const recipe = (name: string, step: object) =>
  JSON.stringify({
    lissom: 1,
    models: { [name]: { file: `${name}.obj` } },
    steps: [{ id: 'curves 1', type: 'curves', model: name, ...step }],
  });

const LIMBS = {
  curves: [
    { id: 'trunk', kind: 'skeleton', rest: line([1.5, 1, 1.5], [1.5, 17.5, 1.5], 4) },
    { id: 'arm', kind: 'skeleton', rest: line([1.5, 17.5, 1.5], [14, 17.5, 1.5], 4) },
    { id: 'other arm', kind: 'skeleton', rest: line([1.5, 17.5, 1.5], [-11, 17.5, 1.5], 4) },
  ],
  links: [
    { child: 'arm', parent: 'trunk', at: 1 },
    { child: 'other arm', parent: 'trunk', at: 1 },
  ],
};
const TUBE = {
  curves: [{ id: 'tube', kind: 'skeleton', rest: line([0, 0.5, 0], [0, 19.5, 0], 5), anchor: 'start' }],
};

const state = (desk: Desk) =>
  desk.page.evaluate(() => {
    const { app } = window.__lissom;
    const { moved, settled } = app.evaluator.result.peek()!;
    return { movable: moved !== null, settled, previews: app.state.previewing.peek() };
  });
const DRAGGED = { movable: true, settled: false, previews: true };
const AT_REST = { movable: false, settled: true, previews: false };

/** Where the core has the vertices, and where the graphics card had them last. */
async function places(desk: Desk) {
  const read = await desk.page.evaluate(() => {
    const { evaluator, wings } = window.__lissom.app;
    const { positions, shown, step } = evaluator.result.peek()!;
    const drawn = (wings.get('curves') as CurvesWing).state.readBack();
    return {
      rest: [...shown.model.positions],
      positions: [...positions],
      drawn: [...(drawn?.positions ?? [])],
      step: JSON.stringify(step),
    };
  });
  return {
    rest: Float64Array.from(read.rest),
    positions: Float64Array.from(read.positions),
    drawn: Float64Array.from(read.drawn),
    step: JSON.parse(read.step) as CurvesStep,
  };
}

/** Bytes that WebGL is given for vertices, from now on. */
const countUploads = (desk: Desk) =>
  desk.page.evaluate(() => {
    const gl = document.querySelector('canvas')!.getContext('webgl2')!;
    const counted = { largest: 0, calls: 0 };
    for (const name of ['bufferData', 'bufferSubData'] as const) {
      const upload = gl[name].bind(gl) as (...args: unknown[]) => void;
      (gl as unknown as Record<string, unknown>)[name] = (...args: unknown[]) => {
        const given = args.find((arg) => ArrayBuffer.isView(arg)) as ArrayBufferView | undefined;
        counted.calls++;
        counted.largest = Math.max(counted.largest, given?.byteLength ?? 0);
        upload(...args);
      };
    }
    (window as unknown as { uploads: typeof counted }).uploads = counted;
  });
const uploads = (desk: Desk) =>
  desk.page.evaluate(() => (window as unknown as { uploads: { largest: number; calls: number } }).uploads);

/** Takes a control point along and holds it there. */
async function hold(desk: Desk, point: Vec3, by: { x: number; y: number }): Promise<void> {
  const [from] = await desk.project(point);
  await desk.hold(from!, by);
  await expect.poll(() => state(desk)).toEqual(DRAGGED);
  await settledDrag(desk);
}

/** Waits until no move is under way. */
async function settledDrag(desk: Desk): Promise<void> {
  let before = '';
  await expect
    .poll(async () => {
      await desk.settled();
      const now = await desk.page.evaluate(() =>
        JSON.stringify(window.__lissom.app.evaluator.result.peek()!.step),
      );
      const same = now === before;
      before = now;
      return same;
    })
    .toBe(true);
}

/** Where the first curve ends. */
const tip = (desk: Desk) =>
  desk.page.evaluate(() => {
    const step = window.__lissom.app.evaluator.result.peek()!.step as CurvesStep;
    return step.curves[0]!.posed!.at(-1)! as Vec3;
  });

async function release(desk: Desk): Promise<void> {
  await desk.page.mouse.up();
  await expect.poll(() => state(desk)).toEqual(AT_REST);
  await desk.settled();
}

/** How far the card's last picture of a drag and what the core made of it are apart, in diagonals. */
const apart = (desk: Desk) =>
  desk.page.evaluate(() => {
    const { evaluator, wings } = window.__lissom.app;
    const { positions, shown } = evaluator.result.peek()!;
    const drawn = (wings.get('curves') as CurvesWing).state.readBack()!.positions;
    const rest = shown.model.positions;
    const [low, high] = [Array(3).fill(Infinity), Array(3).fill(-Infinity)] as [number[], number[]];
    rest.forEach((x, i) => {
      low[i % 3] = Math.min(low[i % 3]!, x);
      high[i % 3] = Math.max(high[i % 3]!, x);
    });
    const worst = drawn.reduce((most, x, i) => Math.max(most, Math.abs(x - positions[i]!)), 0);
    return worst / Math.hypot(...low.map((x, k) => high[k]! - x));
  });

test('linked curves are dragged on the graphics card, which draws what the core computes', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  await desk.choose(['limbs.json', recipe('limbs', LIMBS)], ['limbs.obj', limbsObj()]);
  await page.keyboard.press('v');
  const { rest, positions } = await places(desk);
  expect(gap(positions, rest)).toBeLessThan(1e-9);

  await test.step('an arm', async () => {
    await hold(desk, [14, 17.5, 1.5], { x: -20, y: 60 });
    const during = await places(desk);
    expect(gap(during.positions, rest)).toBeLessThan(1e-9);
    expect(gap(during.drawn, rest)).toBeGreaterThan(1);
    await desk.picture('curves-drag-card');
    await release(desk);
    await desk.picture('curves-drag-core');
    const far = await apart(desk);
    console.log(`graphics card and core: ${far.toExponential(1)} of the diagonal apart`);
    expect(far).toBeLessThan(1e-5);
  });

  await test.step('the trunk takes its arms along; Escape brings back what was', async () => {
    const { positions: posed } = await places(desk);
    await hold(desk, [1.5, 17.5, 1.5], { x: 50, y: 10 });
    expect(gap((await places(desk)).drawn, posed)).toBeGreaterThan(0.5);
    await page.keyboard.press('Escape');
    await expect.poll(() => state(desk)).toEqual(AT_REST);
    await page.mouse.up();
    await desk.settled();
    expect(gap((await places(desk)).positions, posed)).toBe(0);
    await desk.picture('curves-drag-escaped');
  });

  await test.step('twice in a row, reaching, and undone step by step', async () => {
    const { positions: before } = await places(desk);
    await hold(desk, [1.5, 17.5, 1.5], { x: 40, y: 10 });
    await release(desk);
    expect(await apart(desk)).toBeLessThan(1e-5);
    const { step, positions: once } = await places(desk);
    expect(gap(once, before)).toBeGreaterThan(0.5);
    await page.keyboard.press('i');
    await hold(desk, step.curves[0]!.posed!.at(-1)!, { x: -60, y: 15 });
    await release(desk);
    expect(await apart(desk)).toBeLessThan(1e-5);
    expect(gap((await places(desk)).positions, once)).toBeGreaterThan(0.5);
    await desk.press('Control+z');
    expect(gap((await places(desk)).positions, once)).toBe(0);
    await desk.press('Control+z');
    expect(gap((await places(desk)).positions, before)).toBe(0);
  });

  await test.step('a graphics card that forgets is given all again', async () => {
    await page.keyboard.press('i');
    const { step } = await places(desk);
    await hold(desk, step.curves[0]!.rest.at(-1)! as Vec3, { x: 30, y: 5 });
    const { drawn } = await places(desk);
    await page.evaluate(async () => {
      const canvas = document.querySelector('canvas')!;
      const card = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
      const came = (name: string) =>
        new Promise((done) => canvas.addEventListener(name, done, { once: true }));
      const lost = came('webglcontextlost');
      card.loseContext();
      await lost;
      await new Promise((done) => setTimeout(done, 50));
      const restored = came('webglcontextrestored');
      card.restoreContext();
      await restored;
    });
    await desk.settled();
    expect(gap((await places(desk)).drawn, drawn)).toBeLessThan(1e-6);
    await release(desk);
    expect(await apart(desk)).toBeLessThan(1e-5);
  });

  await test.step('the thesis’s planes go by the core, another model by its own curves', async () => {
    await page.getByRole('button', { name: 'Advanced' }).click();
    await page.getByLabel('Places').selectOption('slabs');
    await desk.settled();
    const { step, positions: before } = await places(desk);
    const [from] = await desk.project(step.curves[0]!.posed!.at(-1)! as Vec3);
    await desk.hold(from!, { x: -40, y: 5 });
    await expect.poll(async () => gap((await places(desk)).positions, before)).toBeGreaterThan(0.2);
    expect(await state(desk)).toEqual({ movable: false, settled: false, previews: true });
    await release(desk);
    await desk.choose(['tube.json', recipe('tube', TUBE)], ['tube.obj', tubeObj(24, 60)]);
    await page.keyboard.press('v');
    await hold(desk, [0, 19.5, 0], { x: 40, y: 10 });
    await release(desk);
    expect(await apart(desk)).toBeLessThan(1e-5);
  });

  await test.step('a drag stops where the surface would fold, and what is seen is what remains', async () => {
    const { step } = await places(desk);
    await hold(desk, step.curves[0]!.posed!.at(-1)! as Vec3, { x: -60, y: 320 });
    await expect(page.getByText('so the drag stops', { exact: false }).first()).toBeVisible();
    await desk.picture('curves-drag-stopped');
    const { drawn } = await places(desk);
    await release(desk);
    const { positions, rest: tube } = await places(desk);
    expect(gap(drawn, positions) / diagonal(tube)).toBeLessThan(1e-5);
  });
});

test('a drag of a large model writes no vertex and costs little more than drawing', async ({
  fresh: desk,
}) => {
  const { page } = desk;
  const vertices = 400 * 426 + 2;
  await desk.choose(['tube.json', recipe('tube', TUBE)], ['tube.obj', tubeObj(400, 426)]);
  await page.keyboard.press('v');
  await hold(desk, [0, 19.5, 0], { x: 20, y: 5 });
  const during = await page.evaluateHandle(() => window.__lissom.app.evaluator.result.peek()!.positions);
  await countUploads(desk);
  const at = (await desk.project([0, 19.5, 0]))[0]!;
  for (let i = 1; i <= 8; i++) await page.mouse.move(at.x + 20 + 8 * i, at.y + 5 + 2 * i);
  await settledDrag(desk);
  const { largest, calls } = await uploads(desk);
  console.log(`vertex data of eight moves: ${calls} uploads, the largest ${largest} bytes`);
  expect(largest).toBeLessThan(vertices);
  expect(
    await during.evaluate(
      (positions) => positions === window.__lissom.app.evaluator.result.peek()!.positions,
    ),
  ).toBe(true);
  await release(desk);
  expect(await apart(desk)).toBeLessThan(1e-5);

  await hold(desk, await tip(desk), { x: -30, y: 5 });
  const { alone, moving } = await pictureTimes(desk);
  console.log(
    `a picture of ${vertices} vertices: ${alone.toFixed(0)} ms alone, ${moving.toFixed(0)} ms posed by a curve first, ${(moving / alone).toFixed(2)} times`,
  );
  await page.keyboard.press('Escape');
  await page.mouse.up();
});
