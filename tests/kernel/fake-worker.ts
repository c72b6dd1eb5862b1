import { KernelClient, type WorkerLike } from '../../web/kernel/client';
import type { Port } from '../../web/kernel/messages';
import { type Handlers, serve } from '../../web/kernel/serve';

/** A worker on this thread: everything of the bridge but the thread, over a real message channel. */
export class FakeWorker implements WorkerLike {
  readonly #channel = new MessageChannel();
  terminated = false;
  onmessage: WorkerLike['onmessage'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  onerror: WorkerLike['onerror'] = null;

  constructor(load: (epoch: number) => Promise<Handlers>) {
    this.#channel.port1.onmessage = (event) => this.onmessage?.(event);
    serve(this.#channel.port2 as Port, load);
  }

  postMessage(message: unknown, moved: Transferable[]): void {
    this.#channel.port1.postMessage(message, moved as never);
  }

  terminate(): void {
    this.terminated = true;
    this.#channel.port1.close();
  }

  /** It is gone and nobody is told. */
  vanish(): void {
    this.#channel.port1.close();
  }

  /** An uncaught error in the worker, or a script that could not be fetched. */
  die(message: string): void {
    this.onerror?.({ message, preventDefault() {} } as ErrorEvent);
  }
}

/** A client whose workers answer with `handlers(epoch)`, and the workers it has spawned so far. */
export function connect(handlers: (epoch: number) => Partial<Handlers>) {
  const workers: FakeWorker[] = [];
  const client = new KernelClient(() => {
    const worker = new FakeWorker(async (epoch) => handlers(epoch) as Handlers);
    workers.push(worker);
    return worker;
  });
  return { client, workers };
}
