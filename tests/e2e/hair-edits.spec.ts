import type { ReportOf } from '../../web/run/results';
import { Desk, expect, SIZE, test, withoutPickers } from './desk';
import { along, hair, styleOf } from './hair-desk';

test.use({ viewport: SIZE });

const EDITS = 3;

interface Edit {
  /** Milliseconds from the end of the stroke. */
  readonly first: number;
  readonly all: number;
  /** Seconds in the kernel, for all strands. */
  readonly core: number;
  readonly grow: number;
}

const median = (values: readonly number[]): number => {
  const sorted = [...values].sort((a, b) => a - b);
  return (sorted[Math.floor((sorted.length - 1) / 2)]! + sorted[Math.floor(sorted.length / 2)]!) / 2;
};

test.slow();

test('edits of a full head each bring other strands; how long they took is printed', async ({ page }) => {
  const desk = new Desk(await withoutPickers(page));
  // As people see it, level of detail and all, not as tests do.
  await desk.open('./');
  await desk.choose(['style.json', JSON.stringify(styleOf('hair-waves.json', 20_000, 48))]);
  await desk.settled();
  await desk.press('v');
  await page.evaluate(() => {
    const { evaluator } = window.__lissom.app;
    const times = { up: 0, first: 0, all: 0 };
    addEventListener(
      'pointerup',
      () => Object.assign(times, { up: performance.now(), first: 0, all: 0 }),
      true,
    );
    evaluator.result.subscribe((result) => {
      if (!result?.strands) return;
      const { settled } = result;
      requestAnimationFrame(() =>
        setTimeout(() => {
          const since = performance.now() - times.up;
          times.first ||= since;
          if (settled) times.all = since;
        }),
      );
    });
    Object.assign(window, { editTimes: times });
  });

  const edits: Edit[] = [];
  let { step, hash } = await hair(desk);
  for (let i = 0; i < EDITS; i++) {
    const [at] = await along(desk, step.streams[0]!.points, 0.5);
    if (i === 0) await desk.drag(at!, { x: 0, y: 0 }, 1); // selects the curve
    await desk.drag(at!, { x: i % 2 ? -16 : 16, y: 4 }, 2);
    const now = await hair(desk);
    expect(now.step.streams[0]!.points).toHaveLength(step.streams[0]!.points.length);
    expect(now.hash).not.toBe(hash);
    ({ step, hash } = now);
    await page.waitForFunction(() => (window as never as { editTimes: { all: number } }).editTimes.all > 0);
    edits.push(
      await page.evaluate(() => {
        const { first, all } = (window as never as { editTimes: { first: number; all: number } }).editTimes;
        const {
          update = 0,
          field = 0,
          grow = 0,
        } = window.__lissom.app.evaluator.result.peek()!.report!.seconds;
        return { first, all, core: update + field + grow, grow };
      }),
    );
  }
  const of = (what: keyof Edit): number => median(edits.map((edit) => edit[what]));
  const constraints = await page.evaluate(
    () => (window.__lissom.app.evaluator.result.peek()!.report as ReportOf<'hair'>).constraints,
  );
  console.info(
    `20,000 strands, ${constraints} constraints, 48 nodes; medians of ${EDITS} edits: first strands on screen ` +
      `after ${of('first').toFixed(0)} ms, all after ${of('all').toFixed(0)} ms; ` +
      `core ${(1000 * of('core')).toFixed(0)} ms, of it growth ${(1000 * of('grow')).toFixed(0)} ms ` +
      `(bound ${(1500 * of('grow') + 100).toFixed(0)} ms)`,
  );
});
