// Built-in models that no file holds: made by a worker, with progress and a way out.

import { readFileSync } from 'node:fs';
import { signal } from '@preact/signals';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { busySign } from '../../web/app/busy-sign';
import { type MakingReply, type MakingWorker, madeAside, make } from '../../web/app/making';
import type { Busy } from '../../web/app/state';
import { type BuiltIn, builtInAtOnce } from '../../web/io/built-in';
import { CUBE_OBJ, Tab } from './world';

const entry: BuiltIn = {
  name: 'cube-scaled',
  file: 'cube.obj',
  made: { subdivisions: 3, scales: { size: 0.1, height: 0.2, below: 1 } },
};
const bytes = new TextEncoder().encode(CUBE_OBJ);

/** A worker that answers as the real one does, after being cloned on the way, or never. */
class Fake implements MakingWorker {
  onmessage: MakingWorker['onmessage'] = null;
  onerror: MakingWorker['onerror'] = null;
  ended = false;

  constructor(private readonly behaviour: 'answers' | 'is silent' | 'fails') {}

  postMessage(order: Parameters<typeof make>[0]): void {
    if (this.behaviour === 'is silent') return;
    queueMicrotask(() => {
      if (this.behaviour === 'fails') this.onerror?.({ preventDefault() {} } as ErrorEvent);
      else
        make(structuredClone(order), (reply: MakingReply, transfer) =>
          this.onmessage?.({ data: structuredClone(reply, { transfer }) } as MessageEvent),
        );
    });
  }
  terminate(): void {
    this.ended = true;
  }
}

const aside = (worker: Fake, abort = new AbortController(), order = { entry, bytes }) => {
  const progress: number[] = [];
  const options = { signal: abort.signal, onProgress: (fraction: number) => void progress.push(fraction) };
  return { made: madeAside(order, options, () => worker), progress };
};

test('a model comes from the worker under its own name, and the worker ends', async () => {
  const worker = new Fake('answers');
  const { made, progress } = aside(worker);
  const { model } = await made;
  expect(model.name).toBe('cube-scaled');
  expect(model.positions).toEqual(builtInAtOnce(entry, bytes).model.positions);
  expect(model.positions).toHaveLength(3 * ((12 * 4 ** 3) / 2 + 2));
  expect(progress.length).toBeGreaterThan(2);
  expect(worker.ended).toBe(true);
});

test('without a worker it is made here', async () => {
  const { model } = await aside(new Fake('fails')).made;
  expect(model.positions).toEqual(builtInAtOnce(entry, bytes).model.positions);
  const options = { signal: new AbortController().signal, onProgress: () => {} };
  const here = await madeAside({ entry, bytes }, options, () => {
    throw new Error('no workers here');
  });
  expect(here.model.positions).toEqual(model.positions);
});

test('cancelling ends the worker and rejects at once', async () => {
  const [worker, abort] = [new Fake('is silent'), new AbortController()];
  const { made } = aside(worker, abort);
  abort.abort();
  await expect(made).rejects.toMatchObject({ code: 'cancelled' });
  expect(worker.ended).toBe(true);
  await expect(aside(new Fake('answers'), abort).made).rejects.toMatchObject({ code: 'cancelled' });
});

test('what the reader says of the file comes back as the error it was', async () => {
  const order = { entry, bytes: new TextEncoder().encode('# nothing') };
  const { made } = aside(new Fake('answers'), new AbortController(), order);
  await expect(made).rejects.toMatchObject({ name: 'LissomError', fault: 'input' });
});

test('work within other work covers its sign, and uncovers it at its end', () => {
  vi.useFakeTimers();
  const busy = signal<Busy | null>(null);
  const outer = busySign(busy, 'Opening', () => {});
  vi.advanceTimersByTime(300);
  const inner = busySign(busy, 'Making', () => {});
  vi.advanceTimersByTime(300);
  expect(busy.value?.label).toBe('Making');
  outer.progress(0.5);
  expect(busy.value?.label).toBe('Making');
  inner.say('Making more');
  inner.progress(0.2);
  expect(busy.value).toMatchObject({ label: 'Making more', fraction: 0.2 });
  inner.end();
  expect(busy.value).toMatchObject({ label: 'Opening', fraction: 0.5 });
  outer.end();
  expect(busy.value).toBeNull();
});

const INDEX = JSON.stringify({
  models: [
    { name: 'cube', file: 'cube.obj', title: 'Cube', licence: '', vertices: 8 },
    { ...entry, title: 'Large cube', licence: '', vertices: 386 },
  ],
  examples: [],
});

beforeEach(() =>
  vi.stubGlobal('fetch', async (address: string) => ({
    ok: true,
    arrayBuffer: async () => new TextEncoder().encode(address.endsWith('.json') ? INDEX : CUBE_OBJ).buffer,
  })),
);
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test('the gallery opens it as any other, and says that it is made', async () => {
  const tab = new Tab();
  await tab.app.gallery.start();
  const entries = tab.app.gallery.entries.value;
  expect(entries.map(({ name, made }) => [name, made])).toEqual([
    ['cube', false],
    ['cube-scaled', true],
  ]);
  await tab.app.gallery.open(entries[1]!);
  await tab.app.evaluator.settled();
  expect(tab.app.state.facts.value).toMatchObject({ name: 'cube-scaled', vertices: 386 });
  expect(tab.app.state.recipe.value.models).toEqual({ 'cube-scaled': { builtin: 'cube-scaled' } });
});

test('opening is cancelled from the sign: what was there stays, and nobody complains', async () => {
  vi.stubGlobal(
    'Worker',
    class extends Fake {
      constructor() {
        super('is silent');
      }
    },
  );
  const tab = new Tab();
  await tab.openCube();
  const before = tab.app.state.recipe.value;
  await tab.app.gallery.start();
  const large = tab.app.gallery.entries.value.find(({ made }) => made)!;
  const opening = tab.app.gallery.open(large).catch((error: unknown) => tab.app.messages.failed(error));
  await vi.waitFor(() => expect(tab.app.state.busy.value?.label).toBe('Making Large cube'));
  tab.app.state.busy.value?.cancel?.();
  await opening;
  expect(tab.app.state.busy.value).toBeNull();
  expect(tab.app.state.recipe.value).toBe(before);
  expect(tab.toasts).toEqual([]);
});

test('the index of the gallery counts right what is made', () => {
  const folder = new URL('../../public/gallery/', import.meta.url);
  const { models } = JSON.parse(readFileSync(new URL('index.json', folder), 'utf8')) as {
    models: (BuiltIn & { vertices: number })[];
  };
  const made = models.filter((each) => each.made);
  expect(made.length).toBeGreaterThan(0);
  for (const each of made) {
    const { model } = builtInAtOnce(each, readFileSync(new URL(each.file, folder)));
    expect(model.positions.length / 3).toBe(each.vertices);
    expect(each.vertices).toBeGreaterThan(300_000);
  }
});
