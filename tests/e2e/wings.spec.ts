// Whatever a wing puts on the page it takes off again: counted in a real browser, after everything unused was swept up.

import { type CDPSession, expect, test } from '@playwright/test';
import { IDENTITY } from '../../web/core/affine';
import { parseRecipe } from '../../web/recipe/parse';
import { Desk } from './desk';

/** What is counted in the page itself. */
interface Counts {
  /** Buffers, textures, programs, vertex arrays and framebuffers on the graphics card. */
  readonly drawn: number;
  /** Things that the kernel holds. */
  readonly held: number;
}

/** In the page, before anything runs: counts what is made and given back. */
function count(): void {
  const counts = { drawn: 0, held: 0 };
  Object.assign(window, { __counts: counts });
  const gl = WebGL2RenderingContext.prototype as unknown as Record<string, (...args: unknown[]) => unknown>;
  for (const kind of ['Buffer', 'Texture', 'Program', 'VertexArray', 'Framebuffer', 'Renderbuffer']) {
    const [create, remove] = [gl[`create${kind}`]!, gl[`delete${kind}`]!];
    gl[`create${kind}`] = function (...args) {
      counts.drawn++;
      return create.apply(this, args);
    };
    gl[`delete${kind}`] = function (...args) {
      if (args[0]) counts.drawn--;
      return remove.apply(this, args);
    };
  }
  const { postMessage } = Worker.prototype;
  const makers = new Map<Worker, Set<number>>();
  Worker.prototype.postMessage = function (
    this: Worker,
    message: { id?: number; method?: string },
    transfer: Transferable[],
  ) {
    if (!makers.has(this)) {
      const asked = new Set<number>();
      makers.set(this, asked);
      this.addEventListener('message', ({ data }: MessageEvent<{ id?: number; result?: unknown }>) => {
        if ('result' in data && data.id !== undefined && asked.delete(data.id)) counts.held++;
      });
    }
    if (message.method && /^(open|prepare)/.test(message.method)) makers.get(this)!.add(message.id!);
    if (message.method === 'release') counts.held--;
    return postMessage.call(this, message, { transfer });
  } as typeof postMessage;
}

/** Event listeners that the page still reaches. */
async function listeners(devtools: CDPSession): Promise<number> {
  // Twice: what the first sweep frees may have held more.
  for (let i = 0; i < 2; i++) await devtools.send('HeapProfiler.collectGarbage');
  const { metrics } = await devtools.send('Performance.getMetrics');
  return metrics.find(({ name }) => name === 'JSEventListeners')!.value;
}

/** Whatever its size, it is drawn and computed in no time: what is counted does not depend on it. */
const SMALL = parseRecipe(
  JSON.stringify({
    lissom: 1,
    models: { bar: { builtin: 'bar' } },
    steps: [
      {
        id: 'bend',
        type: 'deform',
        model: 'bar',
        handles: [{ kind: 'region', vertices: { ranges: [[0, 39]] }, matrix: IDENTITY }],
      },
      {
        id: 'fur',
        type: 'hair',
        model: 'bend',
        scalp: { ranges: [[0, 39]] },
        grid: { resolution: 16 },
        strands: { count: 20 },
      },
    ],
  }),
);

test.use({ viewport: { width: 900, height: 600 } });

test('a hundred changes of workspace leave nothing behind', async ({ page }) => {
  test.setTimeout(480_000);
  await page.addInitScript(count);
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable');
  const desk = new Desk(page);
  await desk.open();
  const change = async (times: number, ...workspaces: readonly string[]) => {
    await page.evaluate(
      async ([rounds, ids]) => {
        const { app } = window.__lissom;
        for (let i = 0; i < rounds; i++)
          for (const id of ids) {
            await app.commands.run(`workspace.${id}`);
            await app.evaluator.settled();
            await new Promise(requestAnimationFrame);
          }
      },
      [times / workspaces.length, workspaces] as const,
    );
    await desk.settled();
  };
  const counts = async () => ({
    ...(await page.evaluate(() => (window as unknown as { __counts: Counts }).__counts)),
    listeners: await listeners(devtools),
  });
  await page.evaluate(async (recipe) => {
    const { app } = window.__lissom;
    await app.desk.open({ recipe, title: 'bar' });
  }, SMALL);
  // Every wing and every chunk has been there.
  await change(8, 'hair', 'deform', 'merge', 'deform');
  const before = await counts();
  // Merge makes drawing surfaces of its own, which takes seconds in software.
  await change(20, 'hair', 'deform', 'merge', 'deform');
  await change(80, 'hair', 'deform');
  const after = await counts();
  console.log(`a hundred changes of workspace: ${JSON.stringify(before)} -> ${JSON.stringify(after)}`);
  expect(after).toEqual(before);
});
