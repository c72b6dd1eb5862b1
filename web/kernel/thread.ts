// The kernel in a thread of Node, for the command line: whatever it is at, the process goes on answering and can end it.

import { parentPort, Worker } from 'node:worker_threads';
import { KernelClient, type WorkerLike } from './client';
import { createHandlers } from './handlers/all';
import type { Port, Reply, Request } from './messages';
import { instantiate } from './module';
import { compileKernel } from './node';
import { serve } from './serve';

/** @param entry  a module that calls `serveInThread` when it finds itself in a thread */
export const startThread = (entry: URL): KernelClient => new KernelClient(() => new Thread(entry));

/** The thread's end. */
export function serveInThread(): void {
  serve(parentPort as unknown as Port, async (epoch) =>
    createHandlers(await instantiate(await compileKernel()), epoch),
  );
}

/** A thread as the client knows workers. */
class Thread implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  onerror: WorkerLike['onerror'] = null;
  readonly #worker: Worker;

  constructor(entry: URL) {
    this.#worker = new Worker(entry);
    this.#worker.on('message', (data: Reply) => this.onmessage?.({ data } as MessageEvent<Reply>));
    this.#worker.on('messageerror', () => this.onmessageerror?.({} as MessageEvent));
    this.#worker.on('error', ({ message }) => this.#failed(message));
    this.#worker.on('exit', (code) => this.#failed(`it ended with code ${code}`));
  }

  postMessage(message: Request, moved: Transferable[]): void {
    this.#worker.postMessage(message, moved as ArrayBuffer[]);
  }

  terminate(): void {
    this.onerror = null;
    void this.#worker.terminate();
  }

  #failed(message: string): void {
    this.onerror?.({ message, preventDefault() {} } as ErrorEvent);
  }
}
