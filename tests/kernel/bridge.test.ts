import { afterEach, expect, test, vi } from 'vitest';
import type { LissomError } from '../../web/core/errors';
import type { KernelClient } from '../../web/kernel/client';
import type { KernelId } from '../../web/kernel/contract';
import type { Deformed, PreparedDeform } from '../../web/kernel/contract/deform';
import { Job } from '../../web/kernel/job';
import type { Handlers } from '../../web/kernel/serve';
import { connect } from './fake-worker';

const deform = 1 as KernelId;
const targets = (first: number) => Float64Array.of(first);
const moved = (...numbers: number[]): Deformed => ({
  positions: Float64Array.from(numbers),
  iterations: 1,
  warnings: [],
  seconds: { solve: 0, rotate: 0, reconstruct: 0 },
});
const prepareArgs = { model: 1 as KernelId, roi: new Uint32Array(), handles: [], options: {} };
const never = () => new Promise<never>(() => {});
const refuse = (code: string, fault: string, message = code) => {
  throw Object.assign(new Error(message), { code, fault });
};

let client: KernelClient | undefined;
afterEach(() => client?.dispose());

function bridge(handlers: Partial<Handlers> | ((epoch: number) => Partial<Handlers>)) {
  const connected = connect(typeof handlers === 'function' ? handlers : () => handlers);
  client = connected.client;
  return connected;
}

test('a result comes back to the call that asked, whatever the order', async () => {
  const { client } = bridge({
    async deform({ targets: [turns] }, job) {
      for (let turn = 0; turn < (turns ?? 0); turn++) await job.checkpoint(0);
      return moved(turns ?? 0);
    },
  });
  const answers = await Promise.all(
    [20, 0].map((n) => client.call('deform', { deform, targets: targets(n) })),
  );
  expect(answers.map((answer) => answer.positions[0])).toEqual([20, 0]);
});

test('typed arrays of a result are moved, not copied', async () => {
  const result = moved(1, 2, 3);
  const { client } = bridge({ deform: () => result });
  const answer = await client.call('deform', { deform, targets: targets(0) });
  expect([...answer.positions]).toEqual([1, 2, 3]);
  expect(result.positions.byteLength).toBe(0);
});

test('buffers given away with the arguments are moved, the others stay', async () => {
  const { client } = bridge({
    measure: ({ positions }) => ({ stretch: Float32Array.from(positions) }) as never,
  });
  const given = Float64Array.of(1, 2, 3);
  const kept = Float64Array.of(4);
  const model = 1 as KernelId;
  await client.call('measure', { model, positions: kept });
  const answer = await client.call('measure', { model, positions: given }, { moved: [given.buffer] });
  expect([...answer.stretch]).toEqual([1, 2, 3]);
  expect([given.length, kept.length]).toEqual([0, 1]);
});

test('an error keeps its code, its words and whose fault it is, and the worker lives on', async () => {
  const { client, workers } = bridge({ deform: () => refuse('no-handle', 'input', 'Add a handle.') });
  await expect(client.call('deform', { deform, targets: targets(0) })).rejects.toMatchObject({
    name: 'LissomError',
    code: 'no-handle',
    message: 'Add a handle.',
    fault: 'input',
  });
  expect([workers.length, client.epoch]).toEqual([1, 0]);
});

test('long work reports progress and stops between slices', async () => {
  let slices = 0;
  const { client, workers } = bridge({
    async prepareDeform(_, job) {
      for (; slices < 100_000; slices++) await job.checkpoint(slices / 100_000);
      return {} as PreparedDeform;
    },
  });
  const abort = new AbortController();
  const seen: number[] = [];
  const onProgress = (fraction: number) => {
    seen.push(fraction);
    if (seen.length === 3) abort.abort();
  };
  const call = client.call('prepareDeform', prepareArgs, { signal: abort.signal, onProgress });
  await expect(call).rejects.toMatchObject({ code: 'cancelled', fault: 'cancelled' });
  await new Promise((done) => setTimeout(done, 200));
  expect(slices).toBeLessThan(100_000);
  expect(seen).toHaveLength(3); // none after the cancel
  expect(seen).toEqual([...seen].sort((a, b) => a - b));
  expect(workers).toHaveLength(1); // it stopped by itself
});

test('progress is reported at most every 50 ms', async () => {
  let time = 0;
  const report = vi.fn();
  const job = new Job(new AbortController().signal, report, () => time);
  for (; time < 1000; time += 10) await job.checkpoint(time / 1000);
  expect(report.mock.calls.map(([fraction]) => fraction)).toEqual(
    Array.from({ length: 19 }, (_, i) => (50 * (i + 1)) / 1000),
  );
});

test('what is being made is shown every quarter of a second, to who looks, and never after a cancel', async () => {
  let time = 0;
  const look = { triangles: Uint32Array.of(0, 1, 2), positions: [] };
  const show = vi.fn();
  const job = new Job(
    new AbortController().signal,
    () => {},
    () => time,
    show,
  );
  for (; time < 1000; time += 10) job.look(() => look);
  expect(show).toHaveBeenCalledTimes(3);

  const match = async (_: unknown, making: Job) => {
    for (;;) {
      making.look(() => look);
      await making.checkpoint(0);
    }
  };
  const { client } = bridge({ match });
  const abort = new AbortController();
  const seen: unknown[] = [];
  const onLook = (shown: unknown) => {
    seen.push(shown);
    abort.abort();
  };
  const call = client.call('match', { models: [], options: {} }, { signal: abort.signal, onLook });
  await expect(call).rejects.toMatchObject({ code: 'cancelled' });
  expect(seen).toEqual([look]);
});

test('of a burst of superseded requests only the newest is ever begun', async () => {
  const begun: number[] = [];
  const { client } = bridge({
    deform({ targets: [n] }) {
      begun.push(n ?? 0);
      return moved();
    },
  });
  await client.call('deform', { deform, targets: targets(0) });
  const calls = [1, 2, 3, 4].map((n) => {
    const abort = new AbortController();
    const call = client.call('deform', { deform, targets: targets(n) }, { signal: abort.signal });
    if (n < 4) abort.abort();
    return call.catch((error: LissomError) => error.code);
  });
  expect((await Promise.all(calls)).slice(0, 3)).toEqual(['cancelled', 'cancelled', 'cancelled']);
  expect(begun).toEqual([0, 4]);
});

test('a request cancelled before it is sent never leaves the page', async () => {
  const handler = vi.fn(() => moved());
  const { client } = bridge({ deform: handler });
  const call = client.call('deform', { deform, targets: targets(0) }, { signal: AbortSignal.abort() });
  await expect(call).rejects.toMatchObject({ code: 'cancelled' });
  await client.call('deform', { deform, targets: targets(0) });
  expect(handler).toHaveBeenCalledTimes(1);
});

test('what a cancelled request had already made is released', async () => {
  const abort = new AbortController();
  const release = vi.fn();
  const { client } = bridge({
    prepareDeform() {
      abort.abort(); // the cancellation crosses the answer
      return { id: 7 as KernelId } as PreparedDeform;
    },
    release: ({ id }) => release(id),
    measure: () => ({}) as never,
  });
  const call = client.call('prepareDeform', prepareArgs, { signal: abort.signal });
  await expect(call).rejects.toMatchObject({ code: 'cancelled' });
  await vi.waitFor(() => expect(release).toHaveBeenCalledWith(7));
});

test('a cancelled request that does not stop costs the worker, and the others are told to start again', async () => {
  const { client, workers } = bridge((epoch) => ({
    prepareDeform: () => (epoch === 0 ? never() : ({ id: 8 as KernelId } as PreparedDeform)),
    deform: never,
  }));
  const abort = new AbortController();
  const stuck = client.call('prepareDeform', prepareArgs, { signal: abort.signal });
  const other = client.call('deform', { deform, targets: targets(0) });
  other.catch(() => {});
  await vi.waitFor(() => expect(workers).toHaveLength(1));
  await new Promise((done) => setTimeout(done, 20)); // let it begin
  abort.abort();
  await expect(stuck).rejects.toMatchObject({ code: 'cancelled' });
  await expect(other).rejects.toMatchObject({ code: 'worker-restarted', fault: 'crash' });
  expect(workers.map((worker) => worker.terminated)).toEqual([true, false]);
  expect(client.epoch).toBe(1);
  expect(await client.call('prepareDeform', prepareArgs)).toEqual({ id: 8 });
});

test('a worker that dies fails what was in flight, and the next request meets a new one', async () => {
  const { client, workers } = bridge((epoch) => ({ deform: () => (epoch === 0 ? never() : moved(epoch)) }));
  await expect(client.call('measure', {} as never)).rejects.toMatchObject({ fault: 'crash' }); // no such handler
  expect(client.epoch).toBe(1);
  expect((await client.call('deform', { deform, targets: targets(0) })).positions[0]).toBe(1);
  workers[1]?.die('boom');
  expect(client.epoch).toBe(2);
  expect((await client.call('deform', { deform, targets: targets(0) })).positions[0]).toBe(2);
});

test('a worker that vanishes without a word is missed, and the next request meets a new one', async () => {
  const { client, workers } = bridge((epoch) => ({ deform: () => moved(epoch) }));
  const call = () => client.call('deform', { deform, targets: targets(0) });
  await call();
  workers[0]?.vanish();
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  try {
    const lost = expect(call()).rejects.toMatchObject({ code: 'worker-restarted' });
    vi.advanceTimersByTime(60_000);
    await lost;
  } finally {
    vi.useRealTimers();
  }
  expect((await call()).positions[0]).toBe(1);
});

test('running out of memory is said in a sentence, and the worker is replaced', async () => {
  const exhausted = [
    () => refuse('out-of-memory', 'memory', ''),
    () => {
      throw new RangeError('Array buffer allocation failed');
    },
    () => {
      throw new WebAssembly.RuntimeError('Aborted(OOM). Build with -sASSERTIONS for more info.');
    },
  ];
  const { client } = bridge((epoch) => ({ deform: () => exhausted[epoch]?.() ?? moved(9) }));
  for (const epoch of [1, 2, 3]) {
    await expect(client.call('deform', { deform, targets: targets(0) })).rejects.toMatchObject({
      code: 'out-of-memory',
      fault: 'memory',
      message: expect.stringMatching(/not enough memory.*smaller region/),
    });
    expect(client.epoch).toBe(epoch);
  }
  expect((await client.call('deform', { deform, targets: targets(0) })).positions[0]).toBe(9);
});

test('a kernel that cannot be loaded says so, and is tried again by the next request only', async () => {
  let attempts = 0;
  const { client, workers } = bridge(() => {
    if (++attempts === 1)
      throw Object.assign(new Error('no network'), { code: 'kernel-not-loaded', fault: 'crash' });
    return { deform: () => moved(5) };
  });
  const call = client.call('deform', { deform, targets: targets(0) });
  await expect(call).rejects.toMatchObject({ code: 'kernel-not-loaded', message: 'no network' });
  expect(workers).toHaveLength(1);
  expect((await client.call('deform', { deform, targets: targets(0) })).positions[0]).toBe(5);
});

test('a worker script that cannot be fetched is no silence either', async () => {
  const { client, workers } = bridge({});
  const call = client.call('deform', { deform, targets: targets(0) });
  workers[0]?.die('404');
  await expect(call).rejects.toMatchObject({ code: 'kernel-not-loaded' });
  expect(workers).toHaveLength(1);
});

test('an answer of a terminated worker is not taken for one of its successor', async () => {
  let answer: (result: Deformed) => void = () => {};
  const { client, workers } = bridge((epoch) => ({
    deform: () => (epoch === 0 ? new Promise<Deformed>((resolve) => (answer = resolve)) : moved(epoch)),
  }));
  const first = client
    .call('deform', { deform, targets: targets(0) })
    .catch((error: LissomError) => error.code);
  await new Promise((done) => setTimeout(done, 20));
  workers[0]?.die('boom');
  answer(moved(99));
  expect(await first).toBe('worker-restarted');
  expect((await client.call('deform', { deform, targets: targets(0) })).positions[0]).toBe(1);
});
