import { cancelled } from '../core/errors';
import type { Args, Kernel, Look, Method, Result } from './contract';
import { failureOf } from './failures';
import { breathe, Job } from './job';
import type { Call, Port, Reply, Request } from './messages';

/** What answers a part of the kernel's methods. */
export type HandlersOf<Part> = {
  [M in keyof Part & Method]: (args: Args<M>, job: Job) => Result<M> | Promise<Result<M>>;
};

export type Handlers = HandlersOf<Kernel>;

/**
 * Answers the requests that arrive at `port`, once `load` has made the handlers of this worker's epoch.
 *
 * Requests begin in the order they came, each after a turn of the event loop, so that a burst of them is read
 * whole, with its cancellations, before any is begun: superseded ones never run.
 */
export function serve(port: Port, load: (epoch: number) => Promise<Handlers>): void {
  const waiting: Call[] = [];
  const aborts = new Map<number, AbortController>();
  let handlers: Handlers | undefined;
  let pumping = false;

  const reply = (message: Reply, moved: Transferable[] = []) => port.postMessage(message, moved);

  async function pump(): Promise<void> {
    if (pumping || !handlers) return;
    pumping = true;
    for (await breathe(); waiting.length > 0; await breathe()) void answer(waiting.shift() as Call, handlers);
    pumping = false;
  }

  async function answer({ id, method, args, looks }: Call, by: Handlers): Promise<void> {
    const signal = aborts.get(id)?.signal as AbortSignal;
    try {
      if (signal.aborted) throw cancelled();
      reply({ id, progress: 0 });
      const show = looks && ((look: Look) => reply({ id, look }));
      const job = new Job(signal, (progress) => reply({ id, progress }), undefined, show);
      const handler = by[method] as (
        args: Args<Method>,
        job: Job,
      ) => Result<Method> | Promise<Result<Method>>;
      const result = await handler(args, job);
      reply({ id, result }, buffersOf(result));
    } catch (thrown) {
      reply({ id, error: failureOf(thrown) });
    } finally {
      aborts.delete(id);
    }
  }

  async function start(epoch: number): Promise<void> {
    try {
      handlers = await load(epoch);
      reply({ ready: true });
      await pump();
    } catch (thrown) {
      reply({ unusable: failureOf(thrown) });
    }
  }

  port.onmessage = ({ data }: MessageEvent<Request>) => {
    if ('start' in data) void start(data.start);
    else if ('cancel' in data) aborts.get(data.cancel)?.abort();
    else {
      waiting.push(data);
      aborts.set(data.id, new AbortController());
      void pump();
    }
  };
}

/** The buffers of a result's typed arrays, each once: handlers hand out arrays they own, so they can move. */
function buffersOf(result: Result<Method>): ArrayBuffer[] {
  const arrays = Object.values(result ?? {}).filter((value) => ArrayBuffer.isView(value));
  return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer))];
}
