import { expect, test } from '@playwright/test';
import { Desk } from './desk';

interface Counts {
  /** Listeners of events, on whatever they are. */
  readonly listeners: number;
  /** Buffers, textures, programs, vertex arrays and framebuffers on the graphics card. */
  readonly drawn: number;
  /** Things that the kernel holds. */
  readonly held: number;
}

/** In the page, before anything runs: counts what is made and given back. */
function count(): void {
  const counts = { listeners: 0, drawn: 0, held: 0 };
  Object.assign(window, { __counts: counts });
  const known = new WeakMap<EventTarget, Map<string, Set<unknown>>>();
  const { addEventListener, removeEventListener } = EventTarget.prototype;
  const keyOf = (type: string, options: unknown) =>
    `${type} ${Boolean(typeof options === 'object' ? (options as AddEventListenerOptions | null)?.capture : options)}`;
  EventTarget.prototype.addEventListener = function (type, listener, options) {
    const once = typeof options === 'object' && options?.once;
    const own = known.get(this) ?? new Map<string, Set<unknown>>();
    known.set(this, own);
    const set = own.get(keyOf(type, options)) ?? new Set();
    own.set(keyOf(type, options), set);
    if (listener && !once && !set.has(listener)) {
      set.add(listener);
      counts.listeners++;
      const signal = typeof options === 'object' ? options?.signal : undefined;
      if (signal) addEventListener.call(signal, 'abort', () => set.delete(listener) && counts.listeners--);
    }
    return addEventListener.call(this, type, listener, options);
  };
  EventTarget.prototype.removeEventListener = function (type, listener, options) {
    if (known.get(this)?.get(keyOf(type, options))?.delete(listener)) counts.listeners--;
    return removeEventListener.call(this, type, listener, options);
  };
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
      addEventListener.call(this, 'message', (event) => {
        const { data } = event as MessageEvent<{ id?: number; result?: unknown }>;
        if ('result' in data && data.id !== undefined && asked.delete(data.id)) counts.held++;
      });
    }
    if (message.method && /^(open|prepare)/.test(message.method)) makers.get(this)!.add(message.id!);
    if (message.method === 'release') counts.held--;
    return postMessage.call(this, message, { transfer });
  } as typeof postMessage;
}

test('a hundred changes of workspace leave nothing behind', async ({ page }) => {
  test.setTimeout(900_000);
  await page.addInitScript(count);
  const desk = new Desk(page);
  await desk.open();
  const go = async (times: number) => {
    for (let i = 0; i < times; i++)
      for (const id of ['hair', 'deform', 'merge', 'deform'])
        await page.evaluate(async (workspace) => {
          const { app } = window.__lissom;
          await app.commands.run(`workspace.${workspace}`);
          await app.evaluator.settled();
          await new Promise(requestAnimationFrame);
        }, id);
    await desk.settled();
  };
  const counts = () => page.evaluate(() => ({ ...(window as unknown as { __counts: Counts }).__counts }));
  // A head with hair and a deform step before it; every wing and every chunk has been there once.
  await page.evaluate(async () => {
    const { app } = window.__lissom;
    const entry = app.gallery.entries.value.find(({ name }) => name === 'hair-bob');
    if (!entry) throw new Error('the gallery has no such style');
    const recipe = await app.gallery.recipe(entry.recipe!);
    const steps = recipe.steps.map((step) =>
      step.type === 'hair' ? { ...step, strands: { ...step.strands, count: 300 } } : step,
    );
    await app.desk.open({ recipe: { ...recipe, steps }, title: 'bob' });
  });
  await go(3);
  const before = await counts();
  await go(25);
  const after = await counts();
  console.log(`a hundred changes of workspace: ${JSON.stringify(before)} -> ${JSON.stringify(after)}`);
  expect(after).toEqual(before);
});
