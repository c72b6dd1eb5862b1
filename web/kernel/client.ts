import { cancelled, LissomError } from '../core/errors';
import type { Args, CallOptions, KernelId, KernelPort, Look, Method, Result } from './contract';
import { notLoaded, toError, workerRestarted } from './failures';
import type { Failure, Reply, Request } from './messages';

/** How long a cancelled request may keep the worker busy before it is replaced, in milliseconds. */
const PATIENCE = 150;
/** How long an idle worker may take to begin a request before it is taken for dead, in milliseconds. */
const SILENCE = 5000;

/** What a Worker and a test's stand-in have in common. */
export interface WorkerLike {
  postMessage(message: Request, moved: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<Reply>) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

interface Pending {
  readonly resolve: (result: never) => void;
  readonly reject: (error: LissomError) => void;
  readonly onProgress: ((fraction: number) => void) | undefined;
  readonly onLook: ((look: Look) => void) | undefined;
  /** Stops listening to the caller's signal. */
  detach: () => void;
  begun: boolean;
  cancelled: boolean;
}

/**
 * The page's end of the bridge: every request one typed promise, whatever becomes of the worker.
 *
 * A cancelled request rejects at once. If it has begun and does not stop within 150 ms, the worker is
 * terminated and a new one started: whatever else was in flight rejects with `worker-restarted` and `epoch`
 * grows. The same happens when the worker dies by itself, with or without a word, or runs out of memory.
 */
export class KernelClient implements KernelPort {
  #epoch = 0;
  #nextId = 1;
  #worker: WorkerLike | null = null;
  #ready = false;
  #disposed = false;
  readonly #pending = new Map<number, Pending>();

  /** @param spawn  makes a fresh worker that `serve`s; called again whenever one had to be replaced */
  constructor(private readonly spawn: () => WorkerLike) {
    this.#start();
  }

  get epoch(): number {
    return this.#epoch;
  }

  call<M extends Method>(method: M, args: Args<M>, options: CallOptions = {}): Promise<Result<M>> {
    const { signal, onProgress, onLook, moved = [] } = options;
    if (signal?.aborted) return Promise.reject(cancelled());
    if (this.#disposed) return Promise.reject(workerRestarted());
    const worker = this.#worker ?? this.#start();
    const id = this.#nextId++;
    return new Promise<Result<M>>((resolve, reject) => {
      const onAbort = () => this.#cancel(id);
      signal?.addEventListener('abort', onAbort, { once: true });
      const silence = setTimeout(() => this.#listen(worker, id), SILENCE);
      const detach = () => {
        clearTimeout(silence);
        signal?.removeEventListener('abort', onAbort);
      };
      this.#pending.set(id, {
        resolve,
        reject,
        onProgress,
        onLook,
        detach,
        begun: false,
        cancelled: false,
      });
      try {
        worker.postMessage({ id, method, args, ...(onLook && { looks: true }) } as Request, moved);
      } catch (error) {
        this.#take(id);
        reject(new LissomError('kernel-crash', `The request could not be sent (${error}).`, 'crash'));
      }
    });
  }

  /** Ends the worker for good; what is in flight rejects. */
  dispose(): void {
    this.#disposed = true;
    this.#abandon(workerRestarted());
  }

  #start(): WorkerLike {
    const worker = this.spawn();
    worker.onmessage = ({ data }) => {
      if (worker === this.#worker) this.#receive(data);
    };
    worker.onmessageerror = () => this.#replace(worker);
    worker.onerror = (event) => {
      event.preventDefault();
      this.#replace(worker, this.#ready ? workerRestarted() : notLoaded(event.message ?? 'no reason given'));
    };
    this.#worker = worker;
    worker.postMessage({ start: this.#epoch }, []);
    return worker;
  }

  /** A new worker follows at once, unless the old one never came up: then the next request tries again. */
  #replace(worker: WorkerLike, error = workerRestarted()): void {
    if (worker !== this.#worker) return;
    const cameUp = this.#ready;
    this.#abandon(error);
    if (cameUp) this.#start();
  }

  #abandon(error: LissomError): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#ready = false;
    this.#epoch++;
    const lost = [...this.#pending.keys()];
    for (const id of lost) this.#take(id)?.reject(error);
  }

  #cancel(id: number): void {
    const pending = this.#pending.get(id);
    const worker = this.#worker;
    if (!pending || !worker) return;
    pending.cancelled = true;
    pending.reject(cancelled());
    worker.postMessage({ cancel: id }, []);
    setTimeout(() => {
      if (pending.begun && this.#pending.get(id) === pending) this.#replace(worker);
    }, PATIENCE);
  }

  /** A worker says at once when it begins a request, unless another one keeps it busy: else it is dead. */
  #listen(worker: WorkerLike, id: number): void {
    const isSilent = () =>
      this.#ready && this.#pending.has(id) && ![...this.#pending.values()].some(({ begun }) => begun);
    // Where the page itself was busy, the word may have come and only wait to be heard.
    if (isSilent()) setTimeout(() => isSilent() && this.#replace(worker), PATIENCE);
  }

  #take(id: number): Pending | undefined {
    const pending = this.#pending.get(id);
    this.#pending.delete(id);
    pending?.detach();
    return pending;
  }

  #receive(reply: Reply): void {
    if ('ready' in reply) this.#ready = true;
    else if ('unusable' in reply) this.#fail(reply.unusable);
    else if ('progress' in reply) this.#progress(reply.id, reply.progress);
    else if ('look' in reply) this.#look(reply.id, reply.look);
    else if ('error' in reply) {
      this.#take(reply.id)?.reject(toError(reply.error));
      if (reply.error.fatal && this.#worker) this.#replace(this.#worker);
    } else {
      const pending = this.#take(reply.id);
      if (pending?.cancelled) this.#forget(reply.result);
      pending?.resolve(reply.result as never);
    }
  }

  #fail(failure: Failure): void {
    if (this.#worker) this.#replace(this.#worker, toError(failure));
  }

  #progress(id: number, fraction: number): void {
    const pending = this.#pending.get(id);
    if (!pending) return;
    pending.begun = true;
    if (!pending.cancelled) pending.onProgress?.(fraction);
  }

  #look(id: number, look: Look): void {
    const pending = this.#pending.get(id);
    if (pending && !pending.cancelled) pending.onLook?.(look);
  }

  /** An answer that crossed its cancellation: nobody will release what it made, so we do. */
  #forget(result: Result<Method>): void {
    const { id } = (result ?? {}) as { readonly id?: KernelId };
    if (id !== undefined) void this.call('release', { id }).catch(() => {});
  }
}
